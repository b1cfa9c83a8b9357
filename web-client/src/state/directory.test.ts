import { describe, expect, it, vi } from 'vitest';
import type { User } from '../api/accounts';
import { Directory } from './directory.svelte';
import { Station } from './station.svelte';

/** Calls that read a whole list, by the class or part of the page's wire that has them. */
const lists = Object.entries(
  import.meta.glob<string>(['../api/*.ts', '!../api/*.test.ts'], {
    query: '?raw',
    import: 'default',
    eager: true,
  }),
).flatMap(([, text]) =>
  [...text.matchAll(/\n {2}(?:async )?([a-zA-Z]+)\(\): Promise<[\s\S]{0,40}\[\]> \{/g)].map(
    ([, name]) => name ?? '',
  ),
);
const pages = Object.entries(
  import.meta.glob<string>(['../**/*.{svelte,ts}', '!../**/*.test.ts', '!../api/*.ts', '!../testing.ts'], {
    query: '?raw',
    import: 'default',
    eager: true,
  }),
);
/** The same name in several classes: they are told apart by what they are called on. */
const AMBIGUOUS =
  /(accounts|grants|accessKeys|runs|follows|plans|virtuals|zones|rest|calls)\.([a-zA-Z]+)\(\)/g;

function readersOf(): Map<string, Set<string>> {
  const readers = new Map<string, Set<string>>();
  for (const [path, text] of pages) {
    for (const [, of, name] of text.matchAll(AMBIGUOUS)) {
      if (name !== undefined && lists.includes(name)) {
        // Each store names its own calls like that.
        const key =
          of === 'calls' || of === 'rest' ? (name === 'all' ? `${path} all` : name) : `${of ?? ''}.${name}`;
        readers.set(key, (readers.get(key) ?? new Set()).add(path));
      }
    }
  }
  return readers;
}

describe('a list of the server', () => {
  it('is read by one part of the page alone, whoever shows it', () => {
    expect(lists).toEqual(
      expect.arrayContaining(['users', 'groups', 'fleets', 'organisations', 'endpoints', 'missions']),
    );
    const twice = [...readersOf()]
      .filter(([, where]) => where.size > 1)
      .map(([name, where]) => [name, ...where]);
    expect(twice).toEqual([]);
  });
});

describe('the directory', () => {
  const ann: User = {
    name: 'ann',
    role: 'operator',
    state: 'active',
    mustChangePassword: false,
    onlyGranted: false,
  };

  it('reads anew what is shown when something else changed, and nothing that nobody shows', async () => {
    const { rest } = new Station();
    const users = vi.spyOn(rest.accounts, 'users').mockResolvedValue([ann]);
    const groups = vi.spyOn(rest.grants, 'groups').mockResolvedValue([]);
    const fleets = vi.spyOn(rest.grants, 'fleets').mockResolvedValue([]);
    const directory = new Directory(rest);
    await directory.groups.refresh();
    await directory.users.change(() => Promise.resolve());
    expect(directory.users.items).toEqual([ann]);
    expect(users).toHaveBeenCalledTimes(1);
    await vi.waitFor(() => expect(groups).toHaveBeenCalledTimes(2));
    expect(fleets).not.toHaveBeenCalled();
  });

  it('holds nothing of the user before', async () => {
    const { rest } = new Station();
    vi.spyOn(rest.accounts, 'users').mockResolvedValue([ann]);
    const directory = new Directory(rest);
    await directory.users.refresh();
    directory.clear();
    expect(directory.users.items).toEqual([]);
  });
});
