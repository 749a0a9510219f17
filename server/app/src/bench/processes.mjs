// @ts-check
// Processor time of a browser's pages, from Linux' /proc. Other work on the machine does not count, unlike in the time of day.

import fs from 'node:fs';

const read = (file) => {
  try {
    return fs.readFileSync(file, 'latin1');
  } catch {
    return ''; // it ended, or there is no /proc
  }
};

/** Processes of a browser that show pages: it and its processes start them. */
function renderers(browser) {
  const parents = new Map();
  for (const name of fs.existsSync('/proc') ? fs.readdirSync('/proc') : []) {
    const pid = Number(name);
    const parent = /\) \S (\d+)/.exec(pid > 0 ? read(`/proc/${pid}/stat`) : '');
    if (parent) parents.set(pid, Number(parent[1]));
  }
  const descends = (pid) => pid === browser || (parents.has(pid) && descends(parents.get(pid)));
  return [...parents.keys()].filter((pid) => descends(pid) && read(`/proc/${pid}/cmdline`).includes('--type=renderer'));
}

/** Milliseconds that the main threads of a browser's pages have run; 0 where the system does not tell. Pages that come later do not count. */
export function clockOfPages(browser) {
  let pages = [];
  return () => {
    if (pages.length === 0) pages = renderers(browser);
    return pages.reduce((sum, pid) => sum + Number(read(`/proc/${pid}/task/${pid}/schedstat`).split(' ')[0]), 0) / 1e6;
  };
}
