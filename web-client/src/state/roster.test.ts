import { describe, expect, it } from 'vitest';
import { Roster } from './roster.svelte';

describe('a list that the server keeps', () => {
  it('is read anew after a change', async () => {
    const kept = ['one'];
    const roster = new Roster(() => Promise.resolve([...kept]));

    const done = await roster.change(async () => kept.push('two'));

    expect(done).toBe(true);
    expect(roster.items).toEqual(['one', 'two']);
  });

  it('says why a change failed until one succeeds, also while it is refreshed', async () => {
    const roster = new Roster(() => Promise.resolve(['one']));

    const done = await roster.change(() => Promise.reject(new Error('no')));
    const sentence = roster.problem;
    await roster.refresh();

    expect(done).toBe(false);
    expect(sentence).not.toBeNull();
    expect(roster.items).toEqual(['one']);
    expect(roster.problem).toBe(sentence);
    await roster.change(() => Promise.resolve());
    expect(roster.problem).toBeNull();
  });

  it('forgets that it could not be read once it can', async () => {
    let broken = true;
    const roster = new Roster(() => (broken ? Promise.reject(new Error('no')) : Promise.resolve(['one'])));

    await roster.refresh();
    expect(roster.problem).not.toBeNull();
    broken = false;
    await roster.refresh();

    expect(roster.problem).toBeNull();
    expect(roster.items).toEqual(['one']);
  });
});
