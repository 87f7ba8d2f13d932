import './style.css';
import './search.css';
import './report/report.css';
import { App } from './app';
import { frozenReport } from './report/frozen';
import { showReport } from './report/page';

const root = document.getElementById('app')!;
const frozen = frozenReport();
if (frozen) showReport(root, frozen);
else void new App(root).start();
