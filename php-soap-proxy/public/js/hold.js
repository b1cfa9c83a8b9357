// @ts-check
/** A button that counts only when it is held for 0.8 s, by mouse, finger or keyboard. */

const HOLD_MILLISECONDS = 800;
/** What a browser makes of the release. */
const OF_RELEASE = ['touchend', 'mousedown', 'mouseup', 'click'];

/**
 * What the release does when the button has counted: nothing. By then the page may have changed, and something else
 * lies under the finger. The next press begins with another event, which ends this.
 */
function swallowRelease() {
  const swallow = (/** @type {Event} */ event) => {
    // A click without a pointer is of a keyboard or a screen reader.
    if (event instanceof MouseEvent && event.type === 'click' && event.detail === 0) {
      return;
    }
    event.preventDefault();
    event.stopPropagation();
  };
  const end = (/** @type {PointerEvent} */ event) => {
    if (event.isPrimary) {
      OF_RELEASE.forEach((type) => removeEventListener(type, swallow, true));
      removeEventListener('pointerdown', end, true);
    }
  };
  OF_RELEASE.forEach((type) => addEventListener(type, swallow, { capture: true, passive: false }));
  addEventListener('pointerdown', end, true);
}

/**
 * @param {HTMLButtonElement} button
 * @param {() => void} confirm
 * @param {() => void} tooShort after a press that was let go too early
 */
export function holdToConfirm(button, confirm, tooShort) {
  /** @type {number | null} */
  let since = null;
  let timer = 0;
  let byPointer = false;
  let clicks = 0;
  const isOff = () => button.getAttribute('aria-disabled') === 'true';

  function begin(/** @type {number} */ at) {
    if (since === null && !isOff()) {
      since = at;
      button.classList.add('holding');
      const left = Math.max(0, HOLD_MILLISECONDS - (performance.now() - at));
      // A release that waits in the queue comes first: only then is the time up.
      timer = setTimeout(() => (timer = setTimeout(complete)), left);
    }
  }

  function stop() {
    since = null;
    clearTimeout(timer);
    button.classList.remove('holding');
  }

  function complete() {
    stop();
    if (byPointer) {
      swallowRelease();
    }
    if (!isOff()) {
      confirm();
    }
  }

  /** What counts are the times of the events, not when a busy page handled them. */
  function release(/** @type {number} */ at) {
    if (since !== null && at - since >= HOLD_MILLISECONDS) {
      complete();
    } else if (since !== null) {
      stop();
      tooShort();
    }
  }

  button.addEventListener('pointerdown', (event) => {
    if (event.button === 0) {
      byPointer = true;
      begin(event.timeStamp);
    }
  });
  button.addEventListener('pointerup', (event) => release(event.timeStamp));
  // Off the button, or into scrolling: a change of mind.
  button.addEventListener('pointermove', ({ clientX, clientY }) => {
    const { left, right, top, bottom } = button.getBoundingClientRect();
    if (clientX < left || clientX > right || clientY < top || clientY > bottom) {
      stop();
    }
  });
  button.addEventListener('pointercancel', stop);
  button.addEventListener('blur', stop);
  button.addEventListener('contextmenu', (event) => event.preventDefault());
  button.addEventListener('keydown', (event) => {
    if (event.key === 'Enter' || event.key === ' ') {
      // The browser would make a click of it at once.
      event.preventDefault();
      if (!event.repeat) {
        byPointer = false;
        begin(event.timeStamp);
      }
    }
  });
  button.addEventListener('keyup', (event) => {
    if (event.key === 'Enter' || event.key === ' ') {
      event.preventDefault();
      release(event.timeStamp);
    }
  });
  // Screen readers and switches can only click: for them a second click confirms the first.
  button.addEventListener('click', (event) => {
    if (event.detail !== 0 || isOff()) {
      return;
    }
    clicks += 1;
    if (clicks % 2 === 0) {
      confirm();
    } else {
      tooShort();
    }
  });
}
