// @ts-check
/** The form for a name and password, or an access key; nothing of it is kept once it was sent. */
import { NoAnswer, sentenceOf } from './api.js';
import { byId, setText } from './dom.js';

export class SignIn {
  #api;
  #onSession;
  #form = byId('sign-in');

  /** @param {import('./api.js').Api} api @param {(session: import('./api.js').Session) => void} onSession */
  constructor(api, onSession) {
    this.#api = api;
    this.#onSession = onSession;
    this.#form.addEventListener('submit', (/** @type {SubmitEvent} */ event) => {
      event.preventDefault();
      void this.#submit();
    });
    for (const choice of ['by-password', 'by-key']) {
      byId(choice).addEventListener('change', () => this.#choose());
    }
    this.#choose();
  }

  /** @param {string} reason why one has to sign in (again) */
  show(reason) {
    setText(byId('sign-in-reason'), reason);
    setText(byId('sign-in-problem'), '');
    byId('sign-in-page').hidden = false;
    byId('station').hidden = true;
    (this.#byKey ? byId('key') : byId('user')).focus();
  }

  hide() {
    byId('sign-in-page').hidden = true;
    byId('station').hidden = false;
  }

  get #byKey() {
    return byId('by-key').checked;
  }

  #choose() {
    byId('password-fields').hidden = this.#byKey;
    byId('key-fields').hidden = !this.#byKey;
    for (const name of ['user', 'password', 'key']) {
      byId(name).required = this.#byKey === (name === 'key');
    }
  }

  async #submit() {
    const proof = this.#byKey
      ? { key: byId('key').value.trim() }
      : { user: byId('user').value.trim(), password: byId('password').value };
    const button = byId('sign-in-button');
    button.disabled = true;
    setText(byId('sign-in-problem'), '');
    try {
      const session = await this.#api.signIn(proof);
      byId('password').value = '';
      byId('key').value = '';
      this.#onSession(session);
    } catch (error) {
      const next = error instanceof NoAnswer ? ' Check that it runs, then sign in again.' : '';
      setText(byId('sign-in-problem'), `Not signed in. ${sentenceOf(error)}${next}`);
    } finally {
      button.disabled = false;
    }
  }
}
