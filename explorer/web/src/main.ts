import './style.css';
import './search.css';
import { App } from './app';

void new App(document.getElementById('app')!).start();
