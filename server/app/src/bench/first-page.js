// @ts-check
// Marks what is on the screen of a page, in milliseconds since 1970, when the frame has been painted. It runs before all
// else in the page. jSM is asked for the original as soon as its first round is over: it is `fine` when all faces are there
// with as many bits as the peers have, and `whole` at the end. Pages of ours tell by `shown(name)`.

{
  const PEERS_BITS = 14;
  /** @type {any} */
  const marks = { start: performance.timeOrigin };

  const mark = (name) => {
    requestAnimationFrame(() => {
      const { port1, port2 } = new MessageChannel();
      port1.onmessage = () => (marks[name] ??= performance.timeOrigin + performance.now());
      port2.postMessage(null);
    });
  };

  const look = () => {
    /** @type {HTMLImageElement | null} */
    const image = document.querySelector('img#poster');
    if (image !== null && image.complete && image.naturalWidth > 0 && image.checkVisibility()) mark('poster');
    else if (!marks.whole) requestAnimationFrame(look);
  };

  const isFine = ({ header, batches }) => header?.whole && header.batchFaces[batches - 1] === header.faces && header.precisionBits[batches - 1] >= PEERS_BITS;

  const askForAll = (viewer) => {
    let isAsked = false;
    const timer = setInterval(() => {
      const { figures } = viewer.session;
      const { state, error } = figures;
      if (isFine(figures)) mark('fine');
      if (state === 'error') marks.error = error;
      if (state === 'idle' && !isAsked) {
        isAsked = true;
        viewer.complete();
      }
      if (state === 'complete' || state === 'error') clearInterval(timer);
    }, 20);
  };

  requestAnimationFrame(look);
  document.addEventListener('load', ({ target }) => {
    const name = target instanceof Element ? target.localName : '';
    if (name === 'jsm-viewer' || name === 'model-viewer') mark('picture');
    if (name === 'jsm-viewer') askForAll(target);
    if (name === 'model-viewer') mark('whole');
  }, true);
  document.addEventListener('complete', () => mark('whole'), true);
  addEventListener('error', ({ message }) => (marks.trouble ??= message));
  Object.assign(window, { marks, shown: mark });
}
