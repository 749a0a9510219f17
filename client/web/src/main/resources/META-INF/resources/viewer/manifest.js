// Asks the server for JSON, and says in words what it answers instead.

export class ServerError extends Error {}

export async function fetchJson(url) {
  let response;
  try {
    response = await fetch(url, { headers: { Accept: 'application/json' } });
  } catch {
    throw new ServerError('The server cannot be reached.');
  }
  const isJson = (response.headers.get('Content-Type') ?? '').includes('json');
  const body = isJson ? await response.json().catch(() => null) : null;
  if (!response.ok) throw new ServerError(inWords(body) ?? `The server answered with status ${response.status}.`);
  if (body === null) throw new ServerError('The server sent something that is not a description of models.');
  return body;
}

/** The server's errors say what is wrong and what to do. */
function inWords(body) {
  if (typeof body?.error !== 'string') return null;
  const sentence = (text) => `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
  return body.remedy ? `${sentence(body.error)} ${sentence(body.remedy)}` : sentence(body.error);
}

/** A manifest with absolute addresses. */
export async function fetchManifest(url) {
  const manifest = await fetchJson(url);
  manifest.archiveUrl = new URL(manifest.archiveUrl, url).href;
  return manifest;
}
