import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { createRawSnippet } from 'svelte';
import { afterEach, describe, expect, it, vi } from 'vitest';
import { FollowCalls, type Follow, type PhoneReach } from '../api/follows';
import { Follows } from '../state/follows.svelte';
import { STATION, Station } from '../state/station.svelte';
import { aFollow, aFollowNow, operationsBy } from '../testing';
import CutOff from './CutOff.svelte';
import FollowOverview from './FollowOverview.svelte';
import { Phone } from './phone.svelte';
import type { SendPositions } from './position-uplink.svelte';
import type { Warning } from './warnings';
import Warnings from './Warnings.svelte';
import PinnedWarning from './PinnedWarning.svelte';

afterEach(cleanup);

const BEGAN = Date.parse('2026-01-01T12:00:00Z');
const at = (second: number): string => new Date(BEGAN + second * 1000).toISOString();
const following = (heard: number, reach: PhoneReach, note: string | null = null): Follow =>
  aFollow({ state: 'tracking', since: at(0), note, now: aFollowNow(at(heard), reach) });
const text = (): string => document.body.textContent.replaceAll(/\s+/g, ' ');

describe('a phone that is cut off', () => {
  const cutOff = { follow: aFollow({ state: 'tracking' }), since: BEGAN, now: BEGAN + 31_000 };

  it('has no network: says so, what the drone does, and when it flies home', () => {
    render(CutOff, { props: { ...cutOff, online: false } });
    expect(screen.getByRole('heading', { level: 1 }).textContent).toContain('No network');
    expect(text()).toContain('Copter 1 stands still in the air and waits.');
    expect(text()).toContain('It flies home in 29 s');
    expect(text()).toContain('31 s ago');
  });

  it('has one, and the cloud does not answer: claims nothing of the drone', async () => {
    const { rerender } = render(CutOff, { props: { ...cutOff, online: true } });
    expect(screen.getByRole('heading', { level: 1 }).textContent).toContain('The cloud does not answer');
    expect(text()).toContain(
      'If only the way to this phone is cut, Copter 1 stands still in the air and waits. It flies home in 29 s.',
    );
    expect(text()).toContain('If the cloud is down, it flies home by itself after some seconds.');
    await rerender({ follow: aFollow({ state: 'returning' }) });
    expect(text()).toContain('Copter 1 goes on flying home and lands there.');
    expect(text()).not.toContain('If the cloud');
  });
});

describe('several warnings at once', () => {
  const warning = (key: string, tone: Warning['tone'] = 'amber'): Warning => ({
    key,
    tone,
    words: `${key} it is.`,
    todo: 'Do.',
  });

  it('are one, and how many more; all of them on demand', async () => {
    render(Warnings, { props: { warnings: [warning('red', 'red'), warning('one'), warning('two')] } });
    expect(text()).toContain('red it is.');
    expect(text()).not.toContain('one it is.');
    await fireEvent.click(screen.getByRole('button', { name: 'and 2 more' }));
    expect(screen.getAllByRole('listitem')).toHaveLength(3);
  });
});

describe('the worst warning', () => {
  const worst = { tone: 'red', words: 'No network.' } as const;
  const children = createRawSnippet(() => ({ render: () => '<p>Far down</p>' }));
  const scroll = async (top: number): Promise<void> => {
    const scroller = screen.getByText('Far down').parentElement as HTMLElement;
    scroller.scrollTop = top;
    await fireEvent.scroll(scroller);
  };

  it('stays in sight when the panel is scrolled, and only then', async () => {
    render(PinnedWarning, { props: { worst, children } });
    expect(text()).not.toContain('No network.');
    await scroll(200);
    expect(screen.getByRole('button', { name: 'No network.' })).toBeTruthy();
    await scroll(0);
    expect(screen.queryByRole('button')).toBeNull();
  });

  it('is none while all is well', async () => {
    render(PinnedWarning, { props: { worst: null, children } });
    await scroll(200);
    expect(screen.queryByRole('button')).toBeNull();
  });
});

describe('the page of a phone that was away', () => {
  const taken = vi.fn<SendPositions>().mockResolvedValue({ upTo: null });

  function open(first: Follow, send: SendPositions = taken): { phone: Phone; follows: Follows } {
    const follows = new Follows(new FollowCalls(operationsBy(vi.fn())));
    follows.apply(first);
    const phone = new Phone({ follows, sender: () => send });
    phone.now = BEGAN;
    return { phone, follows };
  }

  it('knows that it was stopped, and for how long the drone waited', () => {
    const { phone, follows } = open(following(10, 'speaks'));
    phone.resume(following(10, 'speaks'));
    phone.update(BEGAN + 1_000);
    follows.applyNow('f1', aFollowNow(at(11)));
    phone.update(BEGAN + 2_000);
    phone.update(BEGAN + 36_000);
    follows.applyNow('f1', aFollowNow(at(45)));
    phone.update(BEGAN + 37_000);
    expect(phone.absence.last).toEqual({
      why: 'asleep',
      seconds: 34,
      waited: 32,
      from: BEGAN + 11_000,
      until: BEGAN + 37_000,
    });
  });

  it('reads first what came before it slept, and loses its network as it wakes', () => {
    const { phone, follows } = open(following(10, 'speaks'));
    phone.resume(following(10, 'speaks'));
    phone.update(BEGAN + 1_000);
    follows.applyNow('f1', aFollowNow(at(11)));
    phone.update(BEGAN + 2_000);
    phone.update(BEGAN + 20_000);
    follows.applyNow('f1', aFollowNow(at(12)));
    phone.update(BEGAN + 20_500);
    phone.absence.suspect('cut', BEGAN + 21_000);
    follows.applyNow('f1', aFollowNow(at(31)));
    phone.update(BEGAN + 22_000);
    expect(phone.absence.last).toMatchObject({ why: 'asleep', seconds: 19 });
  });

  it('takes for one what goes on right after it was opened again', () => {
    const { phone, follows } = open(following(10, 'gone'));
    phone.resume(following(10, 'gone'));
    follows.applyNow('f1', aFollowNow(at(27)));
    phone.update(BEGAN + 1_000);
    expect(phone.absence.last).toMatchObject({ why: 'gone', seconds: 17 });
    phone.update(BEGAN + 8_000);
    follows.applyNow('f1', aFollowNow(at(34)));
    phone.update(BEGAN + 9_000);
    expect(phone.absence.last).toMatchObject({ why: 'gone', seconds: 24, waited: 22 });
  });

  it('does not report that it knows no place before its receiver had a moment', () => {
    const send = vi.fn<SendPositions>().mockResolvedValue({ upTo: null });
    const clock = vi.spyOn(performance, 'now').mockReturnValue(1_000);
    const { phone } = open(following(10, 'speaks'), send);
    phone.resume(following(10, 'speaks'));
    phone.update(BEGAN + 1_000);
    clock.mockReturnValue(20_000);
    phone.update(BEGAN + 20_000);
    expect(send).not.toHaveBeenCalled();
    clock.mockReturnValue(22_000);
    phone.update(BEGAN + 22_000);
    expect(send).toHaveBeenCalledOnce();
    clock.mockRestore();
  });

  it('knows that it was closed, from the follow that it finds', () => {
    const { phone, follows } = open(following(10, 'gone'));
    phone.resume(following(10, 'gone'));
    follows.applyNow('f1', aFollowNow(at(30)));
    phone.update(BEGAN + 1_000);
    expect(phone.absence.last).toMatchObject({ why: 'gone', waited: 18 });
  });
});

describe('the station', () => {
  function show(follow: Follow, second: number): void {
    const station = new Station();
    vi.spyOn(station.rest.follows, 'all').mockResolvedValue([]);
    station.follows.apply(follow);
    station.clock.now = BEGAN + second * 1000;
    render(FollowOverview, { context: new Map([[STATION, station]]) });
  }

  it('shows that a phone is silent, why, for how long, and what the drone will do', async () => {
    show(following(10, 'cut', 'The phone cannot be reached: it has no network.'), 22);
    expect(text()).toContain('1 silent of 1');
    await fireEvent.click(screen.getByRole('button', { name: /^Follow me/ }));
    expect(text()).toContain('Copter 1 stands still and waits for olga');
    expect(text()).toContain('Silent for 12 s; flies home in 48 s.');
    expect(text()).toContain('it has no network');
  });

  it('shows nothing of the kind while positions come', async () => {
    show(following(10, 'speaks'), 11);
    await fireEvent.click(screen.getByRole('button', { name: /^Follow me/ }));
    expect(text()).toContain('Copter 1 follows olga');
    expect(text()).not.toContain('ilent');
  });
});
