// @ts-check
/** The chosen drone: how it is, who commands it, and the buttons that command it. */
import { controlText } from './control.js';
import { byId, setAttribute, setText } from './dom.js';
import {
  armedText,
  batteryText,
  fixed,
  linkText,
  metersText,
  placeOf,
  statusOf,
  UNKNOWN,
  updateText,
  whyNot,
} from './drone.js';
import { Foot, leftText } from './foot.js';
import { distanceMeters, parsePlace, placeText } from './geo.js';
import { holdToConfirm } from './hold.js';

/**
 * @typedef {import('./drone.js').Drone} Drone
 * @typedef {import('./geo.js').Place} Place
 * @typedef {{
 *   commands: import('./commands.js').Commands, control: import('./control.js').Control,
 *   chosen(): Drone | null, target(): Place | null, setTarget(place: Place | null): void, user(): string | null,
 *   whyNoCommand(): string | null, now(): number,
 * }} Page
 */

/** Nobody who pressed "Arm" still means it after so long. */
const MEANT_MILLISECONDS = 15_000;
/** They need control that lasts; whatever ends a flight never waits for it. */
const FLYING = new Set(['setMode', 'arm', 'takeoff', 'goto', 'startMission']);
export class DronePanel {
  #page;
  #foot;
  /** @type {{ name: string, operation: string, action: string, why: () => string | null }[]} */
  #buttons = [];

  /** @param {Page} page */
  constructor(page) {
    this.#page = page;
    this.#foot = new Foot(page);
    this.button('arm', 'arm', 'arm', () => this.#arm());
    this.button('disarm', 'disarm', 'disarm', () => this.send('disarm', 'Disarm'));
    this.button(
      'take-off',
      'takeoff',
      'takeOff',
      () => this.#takeOff(),
      () => whyNoNumber('take-off-height'),
    );
    this.button(
      'fly',
      'goto',
      'goTo',
      () => this.#fly(),
      () => this.#whyNoTarget(),
    );
    this.button('hold', 'hold', 'hold', () => this.send('hold', 'Hold'));
    this.button('return', 'returnToLaunch', 'returnToLaunch', () =>
      this.send('returnToLaunch', 'Return to launch'),
    );
    this.button('land', 'land', 'land', () => this.send('land', 'Land'));
    byId('fly-cancel').addEventListener('click', () => page.setTarget(null));
    byId('fly-place').addEventListener('change', () => {
      const place = parsePlace(byId('fly-place').value);
      if (place !== null) {
        page.setTarget(place);
      }
    });
    byId('take-control').addEventListener('click', () => this.#take());
    this.#onPress('give-back', () => this.#giveBack());
  }

  /**
   * A button that commands; those of the class "hold" have to be held.
   * @param {string} name @param {string} operation @param {string} action in what the server says is allowed
   * @param {() => void} press @param {() => string | null} [why] a reason of the page's own against it
   */
  button(name, operation, action, press, why = () => null) {
    this.#buttons.push({ name, operation, action, why });
    this.#onPress(name, press);
  }

  /** @param {string} name @param {() => void} press */
  #onPress(name, press) {
    const button = byId(name);
    const pressed = () => {
      this.#foot.hint = '';
      press();
    };
    if (button.classList.contains('hold')) {
      const label = byId(`${name}-name`);
      holdToConfirm(button, pressed, () =>
        this.say(`Nothing was sent: hold “${label.textContent}” until its ring is full.`),
      );
    } else {
      button.addEventListener('click', () => button.getAttribute('aria-disabled') === 'true' || pressed());
    }
  }

  /** @param {string} words @param {'hint' | 'note'} [tone] a note is nothing to mend */
  say(words, tone = 'hint') {
    this.#foot.say(words, tone);
  }

  get hint() {
    return this.#foot.hint;
  }

  /** @param {string} operation @param {string} label @param {object} [parameters] */
  async send(operation, label, parameters) {
    const drone = this.#page.chosen();
    if (drone === null) {
      return null;
    }
    const { commands, control } = this.#page;
    const prepare = FLYING.has(operation) ? () => control.ensure(drone.id) : undefined;
    return await commands.send(drone, operation, label, parameters, prepare);
  }

  /** Some modes do not allow arming: the server names one that does. */
  async #arm() {
    const drone = this.#page.chosen();
    const mode = drone?.actions.arm?.mode ?? null;
    const pressed = performance.now();
    if (mode !== null) {
      const changed = await this.send('setMode', `Change the mode to ${mode}`, { mode });
      if (changed?.result !== 'succeeded') {
        return;
      }
      if (this.#page.chosen()?.id !== drone?.id || performance.now() - pressed > MEANT_MILLISECONDS) {
        this.say(
          'It was not armed: the change of its mode took long, or another drone was chosen meanwhile.',
        );
        return;
      }
    }
    await this.send('arm', 'Arm');
  }

  async #takeOff() {
    const altitude = byId('take-off-height').valueAsNumber;
    await this.send('takeoff', `Take off to ${altitude} m`, { altitude });
  }

  async #fly() {
    const target = this.#page.target();
    if (target !== null) {
      const altitude = byId('fly-height').valueAsNumber;
      const { latitude, longitude } = target;
      this.#page.setTarget(null);
      await this.send('goto', `Fly to ${placeText(target)} at ${altitude} m`, {
        latitude,
        longitude,
        altitude,
      });
    }
  }

  #whyNoTarget() {
    if (this.#page.target() === null) {
      return 'Choose a place first.';
    }
    return parsePlace(byId('fly-place').value) === null
      ? 'The place must be latitude, longitude in degrees.'
      : whyNoNumber('fly-height');
  }

  #take() {
    const drone = this.#page.chosen();
    if (drone !== null) {
      void this.#page.control.take(drone.id);
    }
  }

  #giveBack() {
    const drone = this.#page.chosen();
    if (drone !== null) {
      void this.#page.control.giveBack(drone.id);
    }
  }

  render() {
    const drone = this.#page.chosen();
    byId('panel').classList.toggle('empty', drone === null);
    byId('nothing-chosen').hidden = drone !== null;
    byId('chosen').hidden = drone === null;
    byId('foot').hidden = drone === null;
    if (drone !== null) {
      this.#renderHead(drone);
      this.#renderControl(drone);
      this.#renderTarget(drone);
      this.#renderButtons(drone);
    }
    this.#foot.render();
  }

  /** @param {Drone} drone */
  #renderHead(drone) {
    const now = this.#page.now();
    const { words, tone } = statusOf(drone);
    setText(byId('chosen-name'), drone.name);
    setText(byId('chosen-status'), words);
    setAttribute(byId('chosen-status'), 'data-tone', tone);
    setText(byId('chosen-link'), `${drone.vehicle} · ${linkText(drone)} · ${drone.link.transport}`);
    const place = placeOf(drone);
    const home = place !== null && drone.home ? metersText(distanceMeters(place, drone.home)) : UNKNOWN;
    const readings = {
      mode: drone.mode ?? UNKNOWN,
      armed: armedText(drone),
      battery: batteryText(drone),
      height: `${fixed(drone.position?.altitudeAboveHome, 1)} m`,
      speed: `${fixed(drone.motion?.groundSpeed, 1)} m/s`,
      heading: `${fixed(drone.motion?.heading)}°`,
      home,
      gps: drone.gps === null ? UNKNOWN : `${drone.gps.fix} · ${drone.gps.satellites ?? UNKNOWN}`,
      amsl: `${fixed(drone.position?.altitudeAmsl)} m`,
      age: updateText(drone, now),
      place: place === null ? UNKNOWN : placeText(place),
    };
    for (const [name, text] of Object.entries(readings)) {
      setText(byId(`reading-${name}`), text);
    }
  }

  /** @param {Drone} drone */
  #renderControl(drone) {
    const { control, user } = this.#page;
    const kept = control.isKept(drone.id);
    const problem = control.problems.get(drone.id);
    const words = controlText(drone, user(), kept);
    setText(byId('control-words'), problem === undefined ? words : `${words} ${problem}`);
    byId('take-control').hidden = kept;
    byId('give-back').hidden = !kept;
    const { outlook } = drone;
    const isDue =
      outlook !== null && outlook !== undefined && outlook.state !== 'kept' && outlook.state !== 'leftAlone';
    setText(
      byId('outlook'),
      isDue && !control.lost.includes(drone) ? `${outlook.then}${leftText(drone, this.#page.now())}` : '',
    );
  }

  /** @param {Drone} drone */
  #renderTarget(drone) {
    const target = this.#page.target();
    byId('fly-card').hidden = target === null;
    byId('fly-hint').hidden = target !== null;
    const from = placeOf(drone);
    if (target !== null) {
      setText(
        byId('fly-away'),
        from === null ? '' : `${metersText(distanceMeters(from, target))} from where it is`,
      );
    }
  }

  /** @param {Drone} drone */
  #renderButtons(drone) {
    const own = this.#page.whyNoCommand();
    for (const { name, operation, action, why } of this.#buttons) {
      const busy = this.#page.commands.isBusy(drone.id, operation) ? 'Waiting for the drone…' : null;
      const reason = own ?? busy ?? whyNot(drone, action) ?? why();
      const button = byId(name);
      setAttribute(button, 'aria-disabled', String(reason !== null));
      button.classList.toggle('busy', busy !== null && own === null);
      setText(byId(`${name}-why`), reason ?? '');
    }
    const mode = drone.actions.arm?.allowed ? (drone.actions.arm.mode ?? null) : null;
    setText(byId('arm-name'), mode === null ? 'Arm' : `Arm in ${mode}`);
    if (mode !== null && byId('arm-why').textContent === '') {
      setText(byId('arm-why'), `In ${drone.mode} it cannot be armed: its mode is changed first.`);
    }
  }
}

/** Why the number in this field cannot be used; null: it can. @param {string} field */
export function whyNoNumber(field) {
  const { validity, min, max, labels } = byId(field);
  const what = labels[0]?.firstChild?.textContent?.trim() ?? 'The number';
  return validity.valid ? null : `${what} must be ${min} to ${max}.`;
}
