import type { CloudLoss, MissionItem } from '../api/types';
import { addWaypoint, changeWaypoint, draftOf, emptyDraft, type Draft } from '../plan/draft';
import { emptyLanding, LANDING_KEY } from '../plan/landing';
import type { Coordinates } from '../geo/coordinates';

const MOST_UNDO = 100;

/** The missions being planned, one draft a drone, with undo. Which drone is planned for now: `droneId`. */
export class Planner {
  droneId = $state<string | null>(null);
  /** The next place that is chosen on the map is that of the landing. */
  placesLanding = $state(false);
  /** The altitude that the next waypoint gets, metres above home. */
  defaultAltitude = $state<number | null>(20);
  #drafts = $state.raw<ReadonlyMap<string, Draft>>(new Map());
  /** The failsafe of each vehicle for a lost cloud during its mission; it flies on unless chosen otherwise. */
  #cloudLoss = $state.raw<ReadonlyMap<string, CloudLoss>>(new Map());
  /** The drone whose plan was just uploaded, until its panel has shown what comes next. */
  uploaded = $state<string | null>(null);
  /** The draft that is being uploaded to each vehicle. */
  readonly #sent = new Map<string, Draft>();
  #undo = $state.raw<readonly { droneId: string; draft: Draft }[]>([]);

  get draft(): Draft | null {
    return this.draftFor(this.droneId);
  }

  draftFor(droneId: string | null): Draft | null {
    return droneId === null ? null : (this.#drafts.get(droneId) ?? null);
  }

  get canUndo(): boolean {
    return this.#undo.some((step) => step.droneId === this.droneId);
  }

  cloudLossOf(droneId: string): CloudLoss {
    return this.#cloudLoss.get(droneId) ?? 'continue';
  }

  chooseCloudLoss(droneId: string, choice: CloudLoss): void {
    this.#cloudLoss = new Map(this.#cloudLoss).set(droneId, choice);
  }

  /** Opens the editor; a draft that was left there before is still there. */
  begin(droneId: string): void {
    this.droneId = droneId;
    if (this.draft === null) {
      this.#set(droneId, emptyDraft());
    }
  }

  /** Opens the editor with a draft made for the drone, in place of what was drafted before; undo brings that back. */
  beginWith(droneId: string, draft: Draft): void {
    this.begin(droneId);
    this.edit(() => draft);
  }

  stop(): void {
    this.placesLanding = false;
    this.droneId = null;
  }

  edit(change: (draft: Draft) => Draft): void {
    const { droneId, draft } = this;
    if (droneId === null || draft === null) {
      return;
    }
    const next = change(draft);
    if (next !== draft) {
      this.#undo = [...this.#undo, { droneId, draft }].slice(-MOST_UNDO);
      this.#set(droneId, next);
    }
  }

  /** A place that was chosen on the map. */
  addAt(place: Coordinates): void {
    if (this.placesLanding) {
      this.placesLanding = false;
      this.landAt(place);
      return;
    }
    this.edit((draft) => addWaypoint(draft, place, this.defaultAltitude));
  }

  /** The mission is to land there; its waypoints stay. */
  landAt(place: Coordinates): void {
    this.edit((draft) => ({
      ...draft,
      ending: 'land',
      landing: { ...(draft.landing ?? emptyLanding()), place },
    }));
  }

  /** A waypoint, or the landing place, was moved on the map. */
  move(key: number, place: Coordinates): void {
    if (key === LANDING_KEY) {
      this.landAt(place);
    } else {
      this.edit((draft) => changeWaypoint(draft, key, place));
    }
  }

  /** Whether this is what was last sent to the vehicle: edited since, what became of that no longer tells of it. */
  wasSent(droneId: string): boolean {
    const draft = this.draftFor(droneId);
    return draft !== null && this.#sent.get(droneId) === draft;
  }

  /** Puts items into the editor in place of what is there; answers how many it could not take. */
  open(items: readonly MissionItem[]): number {
    const { draft, leftOut } = draftOf(items);
    this.placesLanding = false;
    this.edit((old) => ({
      ...draft,
      waypoints: draft.waypoints.map((waypoint, index) => ({ ...waypoint, key: old.nextKey + index })),
      nextKey: old.nextKey + draft.waypoints.length,
    }));
    return leftOut;
  }

  undo(): void {
    const at = this.#undo.findLastIndex((step) => step.droneId === this.droneId);
    const step = this.#undo[at];
    this.placesLanding = false;
    if (step !== undefined) {
      this.#undo = this.#undo.toSpliced(at, 1);
      this.#set(step.droneId, step.draft);
    }
  }

  /** Remembers the draft that is being uploaded. */
  markSent(): void {
    if (this.droneId !== null && this.draft !== null) {
      this.#sent.set(this.droneId, this.draft);
    }
  }

  /** Discards the draft that was uploaded, unless it was edited meanwhile. */
  markUploaded(droneId: string): void {
    const sent = this.#sent.get(droneId);
    this.#sent.delete(droneId);
    if (sent !== undefined && sent === this.draftFor(droneId)) {
      this.uploaded = this.droneId === droneId ? droneId : null;
      this.#discard(droneId);
    }
  }

  #discard(droneId: string): void {
    const drafts = new Map(this.#drafts);
    drafts.delete(droneId);
    this.#drafts = drafts;
    this.#undo = this.#undo.filter((step) => step.droneId !== droneId);
    if (this.droneId === droneId) {
      this.droneId = null;
    }
  }

  #set(droneId: string, draft: Draft): void {
    this.#drafts = new Map(this.#drafts).set(droneId, draft);
  }
}
