import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { createRawSnippet } from 'svelte';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Hold, HOLD_MILLISECONDS, type HoldClock } from './hold.svelte';
import HoldButton from './HoldButton.svelte';

class FakeClock implements HoldClock {
  time = 0;
  #timers: { at: number; action: () => void }[] = [];
  #frame: (() => void) | null = null;

  now(): number {
    return this.time;
  }

  after(milliseconds: number, action: () => void): () => void {
    const timer = { at: this.time + milliseconds, action };
    this.#timers.push(timer);
    return () => (this.#timers = this.#timers.filter((one) => one !== timer));
  }

  onFrame(action: () => void): () => void {
    this.#frame = action;
    return () => (this.#frame = null);
  }

  advance(milliseconds: number): void {
    this.time += milliseconds;
    for (let due; (due = this.#timers.find((timer) => timer.at <= this.time));) {
      this.#timers = this.#timers.filter((timer) => timer !== due);
      due.action();
    }
    const frame = this.#frame;
    this.#frame = null;
    frame?.();
  }
}

describe('hold to confirm', () => {
  let clock: FakeClock;
  let confirm: ReturnType<typeof vi.fn<() => void>>;
  let hold: Hold;
  beforeEach(() => {
    clock = new FakeClock();
    confirm = vi.fn<() => void>();
    hold = new Hold(confirm, clock);
  });

  it('confirms once after 0.8 s', () => {
    hold.begin(0);
    clock.advance(HOLD_MILLISECONDS / 2);
    expect(hold.progress).toBeCloseTo(0.5);
    expect(confirm).not.toHaveBeenCalled();
    clock.advance(HOLD_MILLISECONDS / 2);
    clock.advance(1000);
    hold.release(clock.time);
    expect(confirm).toHaveBeenCalledTimes(1);
    expect(hold.tooShort).toBe(false);
  });

  it('says so when it was let go too early', () => {
    hold.begin(0);
    clock.advance(300);
    hold.release(300);
    clock.advance(1000);
    expect(confirm).not.toHaveBeenCalled();
    expect(hold.tooShort).toBe(true);
    expect(hold.progress).toBe(0);
  });

  it('counts how long the hand held it when the page was too busy to draw', () => {
    hold.begin(0);
    clock.time = 5000;
    hold.release(900);
    expect(confirm).toHaveBeenCalledTimes(1);
  });

  it('does not take a late release for a long hold', () => {
    hold.begin(0);
    clock.time = 5000;
    hold.release(200);
    expect(confirm).not.toHaveBeenCalled();
  });
});

describe('hold button', () => {
  beforeEach(() =>
    vi.useFakeTimers({
      toFake: [
        'setTimeout',
        'clearTimeout',
        'requestAnimationFrame',
        'cancelAnimationFrame',
        'performance',
        'Date',
      ],
    }),
  );
  afterEach(() => {
    cleanup();
    vi.useRealTimers();
  });

  function button(disabled = false): { confirm: ReturnType<typeof vi.fn>; element: HTMLElement } {
    const confirm = vi.fn();
    const children = createRawSnippet(() => ({ render: () => '<span>Arm</span>' }));
    render(HoldButton, { onconfirm: confirm, disabled, children });
    const element = screen.getByRole('button', { name: 'Arm' });
    element.setPointerCapture = vi.fn();
    element.getBoundingClientRect = () => new DOMRect(0, 100, 100, 40);
    return { confirm, element };
  }

  it('confirms by a held pointer', async () => {
    const { confirm, element } = button();
    await fireEvent.pointerDown(element, { button: 0 });
    vi.advanceTimersByTime(900);
    expect(confirm).toHaveBeenCalledTimes(1);
  });

  it.each([' ', 'Enter'])('confirms by the held key %j, whose repeats count for nothing', async (key) => {
    const { confirm, element } = button();
    await fireEvent.keyDown(element, { key });
    vi.advanceTimersByTime(400);
    await fireEvent.keyDown(element, { key, repeat: true });
    vi.advanceTimersByTime(500);
    await fireEvent.keyUp(element, { key });
    expect(confirm).toHaveBeenCalledTimes(1);
  });

  it('does nothing when the pointer leaves before the time', async () => {
    const { confirm, element } = button();
    await fireEvent.pointerDown(element, { button: 0, clientX: 50, clientY: 120 });
    vi.advanceTimersByTime(400);
    await fireEvent.pointerMove(element, { clientX: 50, clientY: 300 });
    vi.advanceTimersByTime(900);
    expect(confirm).not.toHaveBeenCalled();
  });

  it('goes on when news above it move the button away from under a hand that keeps still', async () => {
    const { confirm, element } = button();
    await fireEvent.pointerDown(element, { button: 0, clientX: 50, clientY: 120 });
    expect(element.setPointerCapture).toHaveBeenCalled();
    vi.advanceTimersByTime(400);
    element.getBoundingClientRect = () => new DOMRect(0, 60, 100, 40);
    await fireEvent.pointerMove(element, { clientX: 51, clientY: 121 });
    await fireEvent.pointerLeave(element, { clientX: 51, clientY: 121 });
    vi.advanceTimersByTime(500);
    expect(confirm).toHaveBeenCalledTimes(1);
  });

  it('keeps saying that it wants holding after a finger was lifted, which ends as a pointer that leaves', async () => {
    const { element } = button();
    await fireEvent.pointerDown(element, { button: 0, clientX: 50, clientY: 120 });
    await fireEvent.pointerUp(element, { clientX: 50, clientY: 120 });
    await fireEvent.pointerLeave(element, { clientX: 50, clientY: 120 });
    expect(screen.getByText('Keep holding until the ring is full.')).toBeTruthy();
  });

  it('does nothing while it is disabled', async () => {
    const { confirm, element } = button(true);
    await fireEvent.pointerDown(element, { button: 0 });
    vi.advanceTimersByTime(900);
    expect(confirm).not.toHaveBeenCalled();
  });
});
