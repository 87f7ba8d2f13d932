// A text as a file that the browser keeps.

/** @returns the file's name */
export function download(text: string, title: string): string {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], { type: 'application/yaml' }));
  link.download = `${title.replace(/[^\w-]+/g, '-').toLowerCase()}.yaml`;
  link.click();
  URL.revokeObjectURL(link.href);
  return link.download;
}
