// Lays the line to the session at once, and starts the page when everything that it needs first has come: until then the
// browser draws its own signs of loading, and where the processor draws, the page's graphics would stand in line behind them.
import * as link from './link.mjs';

link.start();
const start = () =>
  import('./main.mjs').catch((error) => {
    const remark = document.getElementById('remark');
    remark.textContent = `The workbench could not start: ${error.message}`;
    remark.classList.add('shown');
    throw error;
  });
if (document.readyState === 'complete') start();
else addEventListener('load', start, { once: true });
