import { describe, expect, it } from 'vitest';
import { Planner } from './planner.svelte';

const HERE = { latitude: 47, longitude: 8 };

function planning(): Planner {
  const planner = new Planner();
  planner.begin('d1');
  return planner;
}

describe('planner', () => {
  it('gives new waypoints the chosen altitude', () => {
    const planner = planning();
    planner.defaultAltitude = 35;
    planner.addAt(HERE);
    expect(planner.draft?.waypoints[0]?.altitude).toBe(35);
  });

  it('undoes edits one by one', () => {
    const planner = planning();
    planner.addAt(HERE);
    planner.addAt(HERE);
    planner.undo();
    expect(planner.draft?.waypoints).toHaveLength(1);
    planner.undo();
    expect(planner.draft?.waypoints).toHaveLength(0);
    expect(planner.canUndo).toBe(false);
  });

  it('keeps a draft for each drone and undoes only in the open one', () => {
    const planner = planning();
    planner.addAt(HERE);
    planner.begin('d2');
    expect(planner.canUndo).toBe(false);
    planner.addAt(HERE);
    planner.begin('d1');
    planner.undo();
    expect(planner.draft?.waypoints).toHaveLength(0);
    expect(planner.draftFor('d2')?.waypoints).toHaveLength(1);
  });

  it('lets the plan go when it has become true', () => {
    const planner = planning();
    planner.addAt(HERE);
    planner.markSent();
    planner.markUploaded('d1');
    expect(planner.droneId).toBeNull();
    expect(planner.draftFor('d1')).toBeNull();
  });

  it('keeps a plan that was edited after it was sent', () => {
    const planner = planning();
    planner.addAt(HERE);
    planner.markSent();
    planner.addAt(HERE);
    planner.markUploaded('d1');
    expect(planner.draft?.waypoints).toHaveLength(2);
  });

  it('changes nothing when nobody plans', () => {
    const planner = new Planner();
    planner.addAt(HERE);
    expect(planner.draft).toBeNull();
  });
});
