import { describe, expect, it } from 'vitest';
import { ServerList } from './server-list.svelte';

describe('a list that the server keeps', () => {
  it('is read anew after a change', async () => {
    const kept = ['one'];
    const list = new ServerList(() => Promise.resolve([...kept]));

    const done = await list.change(async () => kept.push('two'));

    expect(done).toBe(true);
    expect(list.items).toEqual(['one', 'two']);
  });

  it('says why a change failed until one succeeds, also while it is refreshed', async () => {
    const list = new ServerList(() => Promise.resolve(['one']));

    const done = await list.change(() => Promise.reject(new Error('no')));
    const sentence = list.problem;
    await list.refresh();

    expect(done).toBe(false);
    expect(sentence).not.toBeNull();
    expect(list.items).toEqual(['one']);
    expect(list.problem).toBe(sentence);
    await list.change(() => Promise.resolve());
    expect(list.problem).toBeNull();
  });

  it('forgets that it could not be read once it can', async () => {
    let broken = true;
    const list = new ServerList(() => (broken ? Promise.reject(new Error('no')) : Promise.resolve(['one'])));

    await list.refresh();
    expect(list.problem).not.toBeNull();
    broken = false;
    await list.refresh();

    expect(list.problem).toBeNull();
    expect(list.items).toEqual(['one']);
  });
});
