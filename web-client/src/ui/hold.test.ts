import { cleanup, fireEvent, render, screen } from '@testing-library/svelte';
import { createRawSnippet } from 'svelte';
import { afterEach, beforeEach, describe, expect, it, vi } from 'vitest';
import { Hold, HOLD_MILLISECONDS, type FrameClock } from './hold.svelte';
import HoldButton from './HoldButton.svelte';

class Frames implements FrameClock {
  time = 0;
  #waiting: (() => void) | null = null;

  now(): number {
    return this.time;
  }

  onFrame(action: () => void): () => void {
    this.#waiting = action;
    return () => (this.#waiting = null);
  }

  advance(milliseconds: number): void {
    this.time += milliseconds;
    const action = this.#waiting;
    this.#waiting = null;
    action?.();
  }
}

describe('hold to confirm', () => {
  it('confirms once after 0.8 s', () => {
    const confirm = vi.fn();
    const frames = new Frames();
    const hold = new Hold(confirm, frames);
    hold.begin();
    frames.advance(HOLD_MILLISECONDS / 2);
    expect(hold.progress).toBeCloseTo(0.5);
    expect(confirm).not.toHaveBeenCalled();
    frames.advance(HOLD_MILLISECONDS / 2);
    frames.advance(1000);
    hold.release();
    expect(confirm).toHaveBeenCalledTimes(1);
    expect(hold.tooShort).toBe(false);
  });

  it('says so when it was let go too early', () => {
    const confirm = vi.fn();
    const frames = new Frames();
    const hold = new Hold(confirm, frames);
    hold.begin();
    frames.advance(300);
    hold.release();
    frames.advance(1000);
    expect(confirm).not.toHaveBeenCalled();
    expect(hold.tooShort).toBe(true);
    expect(hold.progress).toBe(0);
  });
});

describe('hold button', () => {
  beforeEach(() =>
    vi.useFakeTimers({ toFake: ['requestAnimationFrame', 'cancelAnimationFrame', 'performance'] }),
  );
  afterEach(() => {
    cleanup();
    vi.useRealTimers();
  });

  function button(disabled = false): { confirm: ReturnType<typeof vi.fn>; element: HTMLElement } {
    const confirm = vi.fn();
    const children = createRawSnippet(() => ({ render: () => '<span>Arm</span>' }));
    render(HoldButton, { onconfirm: confirm, disabled, children });
    return { confirm, element: screen.getByRole('button', { name: 'Arm' }) };
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
    await fireEvent.pointerDown(element, { button: 0 });
    vi.advanceTimersByTime(400);
    await fireEvent.pointerLeave(element);
    vi.advanceTimersByTime(900);
    expect(confirm).not.toHaveBeenCalled();
  });

  it('does nothing while it is disabled', async () => {
    const { confirm, element } = button(true);
    await fireEvent.pointerDown(element, { button: 0 });
    vi.advanceTimersByTime(900);
    expect(confirm).not.toHaveBeenCalled();
  });
});
