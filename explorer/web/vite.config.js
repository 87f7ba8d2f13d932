// The page as five files of fixed names, which the server's table lists, and with the
// licences of what they contain.
import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';

const bundled = ['three'];

function licences() {
  return {
    name: 'licences',
    generateBundle() {
      const parts = bundled.map((name) => {
        const folder = new URL(`node_modules/${name}/`, import.meta.url);
        const { version } = JSON.parse(readFileSync(new URL('package.json', folder)));
        const text = readFileSync(new URL('LICENSE', folder), 'utf8').trim();
        return `${name} ${version}\n\n${text}\n`;
      });
      const own =
        'The explorer of Delos is free software under the GNU General Public License,\n' +
        'version 3 or later; its source is the folder explorer/web of Delos.\n' +
        'It contains:\n';
      this.emitFile({
        type: 'asset',
        fileName: 'licences.txt',
        source: [own, ...parts].join('\n'),
      });
    },
  };
}

export default defineConfig({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  plugins: [licences()],
  build: {
    target: 'es2022',
    modulePreload: false,
    chunkSizeWarningLimit: 1000,
    assetsInlineLimit: 0,
    rollupOptions: {
      output: {
        entryFileNames: 'explorer.js',
        assetFileNames: 'explorer.[ext]',
        inlineDynamicImports: true,
      },
    },
  },
});
