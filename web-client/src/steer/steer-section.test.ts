import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import type { Action, Velocity } from '../api/types';
import { STATION, Station } from '../state/station.svelte';
import { aDrone, anAction } from '../testing';
import SteerSection from './SteerSection.svelte';

const MAY = anAction();

describe('steer section', () => {
  let sent: (Velocity | 'let go' | 'closed')[];
  let refuse: (why: string) => void;
  let made: Station;

  beforeEach(() => {
    vi.useFakeTimers();
    sent = [];
    made = new Station();
    made.connection.up();
    made.session = { name: 'olga', role: 'operator', mustChangePassword: false, organisation: null };
    vi.spyOn(made, 'steering').mockImplementation((_, onRefused) => {
      refuse = onRefused;
      return {
        steer: (velocity) => sent.push(velocity) > 0,
        letGo: () => sent.push('let go'),
        close: () => sent.push('closed'),
      };
    });
  });

  afterEach(() => {
    cleanup();
    vi.useRealTimers();
  });

  function show(velocity: Action = MAY) {
    const drone = aDrone({ kind: 'rover', modes: [], name: 'Burger', actions: { velocity } });
    return render(SteerSection, { props: { drone }, context: new Map([[STATION, made]]) });
  }

  function pad(): HTMLElement {
    return screen.getByRole('application', { name: 'Steer Burger by keys' });
  }

  function ahead(): number {
    return sent.filter((one) => typeof one === 'object' && one.forward > 0).length;
  }

  it('moves as long as a key is down, and says so', async () => {
    show();
    await fireEvent.keyDown(pad(), { code: 'KeyW' });
    await vi.advanceTimersByTimeAsync(450);
    expect(ahead()).toBe(5);
    expect(screen.getByRole('status').textContent).toContain('Steering: 0.3 m/s ahead');
    await fireEvent.keyUp(pad(), { code: 'KeyW' });
    await vi.advanceTimersByTimeAsync(1000);
    expect(sent.slice(5)).toEqual(['let go']);
    expect(screen.getByRole('status').textContent).toBe('Not steering');
  });

  it.each([
    ['the focus goes', () => fireEvent.blur(pad())],
    ['the window is left', () => fireEvent.blur(window)],
    ['Escape is pressed', () => fireEvent.keyDown(document.body, { code: 'Escape' })],
    ['Space is pressed', () => fireEvent.keyDown(pad(), { code: 'Space' })],
    ['the page goes', () => fireEvent(window, new Event('pagehide'))],
    ['the page is hidden', hideDocument],
  ])('lets go when %s', async (_, happens) => {
    show();
    await fireEvent.keyDown(pad(), { code: 'ArrowUp' });
    expect(ahead()).toBe(1);
    await happens();
    await vi.advanceTimersByTimeAsync(1000);
    expect(sent.slice(1)).toEqual(['let go']);
    await fireEvent.keyDown(pad(), { code: 'ArrowUp', repeat: true });
    expect(sent.slice(1)).toEqual(['let go']);
  });

  it('steers nothing, with the reason, where it may not', async () => {
    show(anAction('Take off first.'));
    await fireEvent.keyDown(pad(), { code: 'KeyW' });
    expect(sent).toEqual([]);
    expect(screen.getByText('Take off first.')).toBeDefined();
  });

  it('stops and tells why when the cloud says no', async () => {
    show();
    await fireEvent.keyDown(pad(), { code: 'KeyW' });
    refuse('bob has control.');
    await vi.advanceTimersByTimeAsync(500);
    expect(sent.slice(1)).toEqual(['let go']);
    expect(screen.getByRole('alert').textContent).toBe('bob has control.');
  });

  it('lets go when the panel is left', async () => {
    const { unmount } = show();
    await fireEvent.keyDown(pad(), { code: 'KeyW' });
    unmount();
    expect(sent.slice(1)).toEqual(['let go', 'closed']);
  });

  it('is faster when one wants it to be', async () => {
    show();
    await fireEvent.input(screen.getByRole('slider'), { target: { value: '1' } });
    await fireEvent.keyDown(pad(), { code: 'KeyS' });
    expect(sent[0]).toMatchObject({ forward: -1, turn: 0, frame: 'vehicle' });
  });
});

function hideDocument(): Promise<boolean> {
  vi.spyOn(document, 'hidden', 'get').mockReturnValueOnce(true);
  return fireEvent(document, new Event('visibilitychange'));
}
