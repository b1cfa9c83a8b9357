import { OPERATIONS } from '@dronemap/client';
import { describe, expect, it } from 'vitest';

/** By their paths from `src`, with their text. */
const sources = new Map(
  Object.entries(
    import.meta.glob<string>(['../**/*.{ts,svelte}', '!../**/*.test.ts'], {
      query: '?raw',
      import: 'default',
      eager: true,
    }),
  ).map(([path, text]) => [path.startsWith('./') ? `station${path.slice(1)}` : path.slice(3), text]),
);

/** Nobody is signed in there, and no stream is open. */
const WITHOUT_STREAM = ['session/', 'App.svelte'];
/** Objects whose methods change the page alone, whatever they are called. */
const OF_THE_PAGE = new Set(['planner', 'view', 'preferences', 'input', 'hold']);
/** Operations of the cloud that change something there. */
const CHANGING = Object.entries(OPERATIONS).flatMap(([id, { method }]) => (method === 'GET' ? [] : [id]));
/** One of several operations, all of which change something. */
const CHANGES = /\[ACTIONS\[/;
/** Calls that look, though they send something, and what works on the page's own state under a name that also changes. */
const READS = new Set(['streamTicket', 'compareParameterFile', 'order', 'positions', 'signIn', 'verify']);
/** The page's own, where the name is that of one that changes; who signs out needs no stream. */
const OWN = new Set([
  'runs.selectTool',
  'runs.show',
  'station.retryNow',
  'station.signOut',
  'station.signOutEverywhere',
]);

/** The methods of a class in a source, each with its text. */
function methodsOf(source: string): [string, string][] {
  const parts = source.split(/\n {2}(?:async )?(?=#?[a-z][A-Za-z]*(?:<[^>]*>)?\()/);
  return parts.slice(1).map((part) => [/^#?[A-Za-z]+/.exec(part)?.[0] ?? '', part]);
}

/** Names of methods that change something at the cloud: by themselves, or by one of those. */
function changing(): Set<string> {
  const all = [...sources]
    .filter(([name]) => /^(api|state|follow)\/.*\.ts$/.test(name))
    .flatMap(([, text]) => methodsOf(text));
  const known = new Set([...CHANGING, ...all.filter(([, text]) => CHANGES.test(text)).map(([name]) => name)]);
  for (let size = -1; size !== known.size;) {
    size = known.size;
    for (const [name, text] of all) {
      const calls = [
        ...text.matchAll(/(?:calls|port|ports\.follows|rest|operations|this)\.(#?[a-zA-Z]+)\(/g),
      ];
      if (calls.some(([, call]) => known.has(call ?? '') && !READS.has(call ?? ''))) {
        known.add(name);
      }
    }
  }
  READS.forEach((name) => known.delete(name));
  return known;
}

/** The handler of a tag, with the functions of the component that it calls. */
function handlerOf(tag: string, source: string): string {
  const handler = /on(?:click|submit)=\{([\s\S]*)/.exec(tag)?.[1] ?? '';
  const named = [...source.matchAll(/\n {2}(?:async )?function ([a-zA-Z]+)\([\s\S]*?\n {2}\}/g)]
    .filter(([, name]) => new RegExp(`(?<![.\\w])${name ?? ''}\\b`).test(handler))
    .map(([text]) => text);
  return [handler, ...named].join('\n');
}

function changesSomething(handler: string, changes: Set<string>): boolean {
  return [...handler.matchAll(/(\w+)\.(#?[a-zA-Z]+)\(/g)].some(
    ([, of, call]) =>
      changes.has(call ?? '') && !OF_THE_PAGE.has(of ?? '') && !OWN.has(`${of ?? ''}.${call ?? ''}`),
  );
}

/** Native buttons and forms that change something, and do not check the connection, as `CloudButton` does. */
function bare(name: string, source: string, changes: Set<string>): string[] {
  const asks = /blocked|unready|why|disabled=\{off\}|offline/i;
  return [...source.matchAll(/<(?:button|form)\b[\s\S]*?(?=\n\s*>|[^=]>)/g)]
    .map(([tag]) => tag)
    .filter((tag) => changesSomething(handlerOf(tag, source), changes))
    .filter((tag) => !asks.test(tag) && !(tag.startsWith('<form') && /<CloudButton|blocked|why/.test(source)))
    .map((tag) => `${name}: ${tag.replace(/\s+/g, ' ').slice(0, 110)}`);
}

describe('without a connection to the cloud', () => {
  const changes = changing();

  it('what changes something there is known from the code', () => {
    const some = ['sendCommand', 'send', 'take', 'grant', 'pause', 'act', 'offer', 'enrol', 'accept', 'save'];
    expect(some.filter((name) => !changes.has(name))).toEqual([]);
  });

  it('no button sends anything: each checks the connection first and says why it does not', () => {
    const all = [...sources]
      .filter(([name]) => name.endsWith('.svelte') && !WITHOUT_STREAM.some((where) => name.startsWith(where)))
      .flatMap(([name, text]) => bare(name, text, changes));
    expect(all).toEqual([]);
  });
});
