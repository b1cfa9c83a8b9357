// @ts-check
/** Calls of the two PHP programs beside this page. Nothing else is called from here. */

const UNSENT = new Set(['proxy-server-unreachable', 'proxy-extension-missing']);
const TOKEN = 'dronemap-token';
/** Longer than the proxy waits for the server, which knows more about what happened. */
const ANSWER_MILLISECONDS = 30_000;

/** @typedef {{ user: string | null, expires: string, token?: string }} Session `user` null: signed in by a key */

/** A request that was answered, and not carried out; `message` is the sentence for people. */
export class Problem extends Error {
  /** @param {number} status @param {{ detail?: string, title?: string, code?: string }} body */
  constructor(status, body) {
    super(body.detail ?? body.title ?? `The server answered with status ${status}.`);
    this.status = status;
    this.code = body.code ?? null;
  }
}

/** A request without an answer: it may have arrived. */
export class NoAnswer extends Error {}

/** Whether nothing of the request has reached the Dronemap server. @param {unknown} error */
export function isUnsent(error) {
  return isSignedOut(error) || (error instanceof Problem && UNSENT.has(error.code ?? ''));
}

/** Whether the way to the server is broken, or the server itself; else it has refused. @param {unknown} error */
export function isBroken(error) {
  return !(error instanceof Problem) || error.status >= 500 || isSignedOut(error);
}

/** @param {unknown} error */
export function isSignedOut(error) {
  return error instanceof Problem && (error.status === 401 || error.code === 'proxy-token-wrong');
}

/** @param {unknown} error */
export function sentenceOf(error) {
  return error instanceof Error ? error.message : String(error);
}

/** The token of this tab; the cookie that belongs to it cannot be read by any script. */
export class Api {
  /** Called when an answer says that the session is over. */
  onSignedOut = () => {};
  /** The server's clock minus this machine's, in milliseconds, as well as the head of an answer tells it. */
  clockOffset = 0;

  get hasToken() {
    return sessionStorage.getItem(TOKEN) !== null;
  }

  forget() {
    sessionStorage.removeItem(TOKEN);
  }

  /** @param {{ user: string, password: string } | { key: string }} proof @returns {Promise<Session>} */
  async signIn(proof) {
    this.forget();
    const session = await this.#fetch('session.php', 'POST', proof);
    sessionStorage.setItem(TOKEN, session.token);
    return session;
  }

  /** @returns {Promise<Session>} */
  async session() {
    return await this.#fetch('session.php', 'GET');
  }

  async signOut() {
    await this.#fetch('session.php', 'DELETE');
    this.forget();
  }

  /** The value that the operation of SOAP returns. @param {string} operation @param {object} [parameters] */
  async call(operation, parameters) {
    const address = `proxy.php?operation=${encodeURIComponent(operation)}`;
    const token = sessionStorage.getItem(TOKEN);
    try {
      return await this.#fetch(address, parameters === undefined ? 'GET' : 'POST', parameters);
    } catch (error) {
      // An answer to the session before does not end the one of now.
      if (isSignedOut(error) && token === sessionStorage.getItem(TOKEN)) {
        this.forget();
        this.onSignedOut();
      }
      throw error;
    }
  }

  /** @param {string} address @param {string} method @param {object} [body] @returns {Promise<any>} */
  async #fetch(address, method, body) {
    /** @type {Record<string, string>} */
    const headers = { Accept: 'application/json' };
    const token = sessionStorage.getItem(TOKEN);
    if (token !== null) {
      headers['X-Dronemap-Token'] = token;
    }
    if (body !== undefined) {
      headers['Content-Type'] = 'application/json';
    }
    const text = body === undefined ? null : JSON.stringify(body);
    const signal = AbortSignal.timeout(ANSWER_MILLISECONDS);
    let answer, content;
    try {
      answer = await fetch(address, { method, headers, body: text, signal, cache: 'no-store' });
      content = await answer.text();
    } catch {
      throw new NoAnswer('The server of this page does not answer.');
    }
    const date = Date.parse(answer.headers.get('Date') ?? '');
    if (!Number.isNaN(date)) {
      // It is told in whole seconds, cut off.
      this.clockOffset = date + 500 - Date.now();
    }
    return valueOf(answer, content);
  }
}

/** @param {Response} answer @param {string} content */
function valueOf(answer, content) {
  if (answer.status === 204) {
    return null;
  }
  let value;
  try {
    value = JSON.parse(content);
  } catch {
    throw new NoAnswer(`The server of this page answered with status ${answer.status} and no JSON.`);
  }
  if (!answer.ok) {
    throw new Problem(answer.status, value);
  }
  return value;
}
