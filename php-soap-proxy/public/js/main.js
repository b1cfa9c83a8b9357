// @ts-check
/** Puts the page together: who is signed in, which drone is chosen, and what is drawn when something has changed. */
import { Api, isSignedOut, NoAnswer, sentenceOf } from './api.js';
import { Commands } from './commands.js';
import { Control } from './control.js';
import { byId, setAttribute, setText } from './dom.js';
import { foldDrones, renderDrones } from './drone-list.js';
import { DronePanel } from './drone-panel.js';
import { isAirborne, placeOf, spanText } from './drone.js';
import { Fleet } from './fleet.js';
import { distanceMeters, placeText } from './geo.js';
import { FlightMap } from './map.js';
import { MissionPanel } from './mission-panel.js';
import { Drafts, withChange } from './mission.js';
import { SignIn } from './sign-in.js';

/** @typedef {import('./geo.js').Place} Place */

const CHOSEN = 'dronemap-chosen';
const SESSION_ENDED = 'Your session has ended. Sign in again; your draft of a mission is kept.';
const STALE_MILLISECONDS = 3000;
const TRACK_POINTS = 900;
const TRACK_METERS = 0.5;
const TOOL_HINTS = matchMedia('(pointer: coarse)').matches
  ? {
      look: 'Tap a drone to choose it. Two fingers move the map.',
      fly: 'Tap the place to fly to; nothing is sent yet.',
      waypoints: 'Tap to add waypoints, drag to move them.',
    }
  : {
      look: 'Click a drone to choose it; drag and wheel move the map.',
      fly: 'Click the place to fly to; nothing is sent yet.',
      waypoints: 'Click to add waypoints, drag to move them. Keys: arrows, then Enter.',
    };

const api = new Api();
const fleet = new Fleet(api, update);
const commands = new Commands(api, update);
const control = new Control(api, update);
const drafts = new Drafts();
/** @type {Map<string, Place[]>} */
const tracks = new Map();
/** Null: signed in by an access key, which does not say whose it is; answers to commands do. @type {string | null} */
let user = null;
/** @type {string | null} */
let chosenId = sessionStorage.getItem(CHOSEN);
/** @type {Place | null} */
let target = null;
/** @type {import('./map.js').Tool} */
let tool = 'look';
/** Why signing out has not succeeded. */
let signOutProblem = '';

const chosen = () => fleet.drones.find((drone) => drone.id === chosenId) ?? null;
const draft = () => drafts.of(chosenId);
const now = () => Date.now() + api.clockOffset;

const panel = new DronePanel({
  ...{ commands, control, chosen, setTarget, now, whyNoCommand },
  target: () => target,
  user: () => user ?? commands.user,
});
const missionPanel = new MissionPanel({ chosen, draft, setDraft }, panel);
const map = new FlightMap({
  scene: () => ({ drones: fleet.drones, chosen: chosen(), draft: draft(), target: goal(), tool, tracks }),
  ...{ choose, setTarget },
  addWaypoint: (place) => missionPanel.add(place),
  moveWaypoint: (key, place) => setDraft(withChange(draft(), key, place)),
});
const signIn = new SignIn(api, begin);

/** The place that is to be confirmed, or is being flown to. @returns {Place | null} */
function goal() {
  const flight = chosenId === null ? undefined : commands.newestFlight(chosenId);
  const isUnderWay = flight?.operation === 'goto' && (flight.progress?.state ?? 'goesOn') === 'goesOn';
  return target ?? (isUnderWay ? flight.goal : null);
}

/** @param {import('./mission.js').Draft} changed */
function setDraft(changed) {
  if (chosenId !== null) {
    drafts.put(chosenId, changed);
    update();
  }
}

/** @param {string} id */
function choose(id) {
  if (id !== chosenId) {
    chosenId = id;
    target = null;
    sessionStorage.setItem(CHOSEN, id);
    update();
  }
}

/** @param {string} id */
function chooseAndShow(id) {
  choose(id);
  foldDrones(true);
  // The row that had the focus may be gone; where nothing folds, this does nothing.
  byId('drone-line').focus();
  update();
  const drone = chosen();
  map.show(drone === null ? null : placeOf(drone));
}

/** @param {Place | null} place */
function setTarget(place) {
  const drone = chosen();
  if (place !== null && drone === null) {
    return;
  }
  if (place !== null && target === null) {
    // While it climbs, the height that it is at is none to fly away at.
    const height = Math.round(drone?.position?.altitudeAboveHome ?? 0);
    byId('fly-height').value = String(Math.max(height, byId('take-off-height').valueAsNumber || 0));
  }
  target = place;
  byId('fly-place').value = place === null ? '' : placeText(place);
  update();
}

/** Also while a question is still waiting for its answer: the server may hang. */
function isStale() {
  return fleet.silentMilliseconds > STALE_MILLISECONDS;
}

function whyNoCommand() {
  return isStale() ? 'No connection to the server.' : null;
}

function update() {
  const { drones } = fleet;
  if (chosenId === null && drones.length === 1 && drones[0] !== undefined) {
    chosenId = drones[0].id;
  }
  for (const drone of drones) {
    remember(drone);
  }
  commands.watch(drones);
  control.watch(drones, user ?? commands.user);
  renderDrones(drones, chosenId, now(), chooseAndShow);
  panel.render();
  missionPanel.render();
  renderConnection();
  renderTool();
  map.draw();
}

/** @param {import('./drone.js').Drone} drone */
function remember(drone) {
  const place = placeOf(drone);
  const track = tracks.get(drone.id) ?? [];
  const last = track.at(-1);
  if (place !== null && (last === undefined || distanceMeters(last, place) > TRACK_METERS)) {
    tracks.set(drone.id, [...track, place].slice(-TRACK_POINTS));
  }
}

function renderConnection() {
  const { problem, answeredAt, waitMilliseconds } = fleet;
  const broken = problem !== null || isStale();
  const line = byId('connection');
  setAttribute(line, 'data-tone', broken ? 'act' : 'good');
  setText(line, broken ? '▲ No connection' : answeredAt === null ? 'Connecting…' : '● Connected');
  byId('trouble').hidden = !broken && signOutProblem === '';
  setText(byId('trouble-sign-out'), signOutProblem);
  const why = problem ?? 'The Dronemap server does not answer.';
  const again = problem === null ? 'Still waiting.' : `Asked again every ${waitMilliseconds / 1000} s.`;
  setText(byId('trouble-why'), broken ? `No connection to the drones. ${why} ${again}` : '');
  // Not read out each second.
  const age = answeredAt === null ? '' : `What is shown is ${spanText(Date.now() - answeredAt)} old.`;
  setText(byId('trouble-age'), broken ? age : '');
  byId('station').classList.toggle('stale', broken);
}

function renderTool() {
  for (const name of /** @type {const} */ (['look', 'fly', 'waypoints'])) {
    byId(`tool-${name}`).checked = tool === name;
  }
  const needsDrone = tool !== 'look' && chosen() === null;
  setText(byId('map-hint'), needsDrone ? 'Choose a drone in the list first.' : TOOL_HINTS[tool]);
}

/** @param {import('./api.js').Session} session */
function begin(session) {
  ({ user } = session);
  signOutProblem = '';
  setText(byId('who'), user ?? 'by access key');
  commands.session = `${user} ${session.expires}`;
  signIn.hide();
  fleet.start();
  update();
}

api.onSignedOut = () => {
  fleet.stop();
  signIn.show(SESSION_ENDED);
};

for (const name of /** @type {const} */ (['look', 'fly', 'waypoints'])) {
  byId(`tool-${name}`).addEventListener('input', () => {
    tool = name;
    update();
  });
}
document.addEventListener('input', update);
byId('drone-line').addEventListener('click', () => {
  foldDrones(byId('drone-line').getAttribute('aria-expanded') === 'true');
  update();
});
// Ages and countdowns go on while nobody answers.
setInterval(() => document.hidden || update(), 1000);

byId('sign-out').addEventListener('click', async () => {
  const flying = fleet.drones.find((drone) => control.isKept(drone.id) && isAirborne(drone));
  const warning = `${flying?.name} is in the air: it is brought home once you sign out. Press “Sign out” again to do so.`;
  if (flying !== undefined && panel.hint !== warning) {
    panel.say(warning);
    return;
  }
  try {
    await control.giveAllBack();
    await api.signOut();
  } catch (error) {
    if (!isSignedOut(error)) {
      signOutProblem = `You are still signed in. ${sentenceOf(error)} Press “Sign out” again.`;
      update();
      return;
    }
  }
  sessionStorage.clear();
  location.reload();
});

async function open() {
  if (!api.hasToken) {
    signIn.show('');
    return;
  }
  try {
    begin(await api.session());
  } catch (error) {
    if (isSignedOut(error)) {
      api.forget();
      signIn.show(SESSION_ENDED);
    } else if (error instanceof NoAnswer) {
      signIn.show(`${sentenceOf(error)} Load this page again when it runs.`);
    } else {
      signIn.show(sentenceOf(error));
    }
  }
}

commands.resume();
void open();
