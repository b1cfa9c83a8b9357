import type { Station } from '../state/station.svelte';

/** Ways to put the focus into the fleet list. */
export interface FleetFocus {
  search(): void;
  row(): void;
}

/** Answers true when the key meant something to the page. Keys typed into a field are the field's, but for Esc. */
export function handleKey(event: KeyboardEvent, station: Station, fleet: FleetFocus): boolean {
  if (event.key === 'Escape') {
    return stepBack(station);
  }
  if (isTyping(event.target)) {
    return false;
  }
  if (event.key === '?') {
    station.view.helpOpen = !station.view.helpOpen;
    return true;
  }
  if (event.key === '/') {
    fleet.search();
    return true;
  }
  if ((event.key === 'ArrowDown' || event.key === 'ArrowUp') && event.target === document.body) {
    fleet.row();
    return true;
  }
  return undoes(event, station);
}

function undoes(event: KeyboardEvent, station: Station): boolean {
  if (
    event.key.toLowerCase() === 'z' &&
    (event.ctrlKey || event.metaKey) &&
    station.planner.droneId !== null
  ) {
    station.planner.undo();
    return true;
  }
  return false;
}

/** Esc closes one thing at a time, the newest first. */
function stepBack(station: Station): boolean {
  const { dispatches, view, planner, runs } = station;
  if (view.helpOpen) {
    view.helpOpen = false;
  } else if (dispatches.picking || dispatches.place !== null) {
    dispatches.leave();
  } else if (view.target !== null) {
    view.target = null;
  } else if (view.page !== 'map') {
    view.page = 'map';
  } else if (runs.tool !== null) {
    runs.clearTool();
  } else if (planner.placesLanding) {
    planner.placesLanding = false;
  } else if (planner.droneId !== null) {
    planner.stop();
  } else if (view.selectedId !== null) {
    view.deselect();
  } else {
    return closesRun(station);
  }
  return true;
}

function closesRun({ runs }: Station): boolean {
  if (runs.shown === null) {
    return false;
  }
  if (runs.chosen === null) {
    runs.leave();
  } else {
    runs.choose(null);
  }
  return true;
}

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && target.closest('input, textarea, select') !== null;
}
