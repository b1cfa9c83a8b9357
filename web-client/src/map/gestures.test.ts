import type { Map as MapLibre } from 'maplibre-gl';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { PressGestures, type PressHandler } from './gestures';

type Listener = (event: object) => void;

/** A map that only hands on what a hand does to it. */
class Hands {
  readonly #listeners = new Map<string, Listener>();
  readonly clicked = vi.fn();
  readonly pressed = vi.fn<PressHandler['onPress']>();

  constructor(waypoint: number | null = null) {
    const map = { on: (kind: string, listener: Listener) => this.#listeners.set(kind, listener) };
    new PressGestures(map as unknown as MapLibre, {
      isWaypoint: () => waypoint,
      onPress: this.pressed,
      onDrop: vi.fn(),
      onClick: this.clicked,
    });
  }

  does(kind: string): void {
    const lngLat = { wrap: () => ({ lat: 47, lng: 8 }) };
    const event = { originalEvent: { button: 0 }, point: { x: 5, y: 5 }, lngLat, preventDefault: vi.fn() };
    this.#listeners.get(kind)?.(event);
  }
}

beforeEach(() => vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

function pressedLong(hands: Hands): void {
  hands.does('mousedown');
  vi.advanceTimersByTime(600);
  hands.does('mouseup');
  hands.does('click');
}

test('a long press that means something is not a click as well', () => {
  const hands = new Hands();
  hands.pressed.mockReturnValue(true);
  pressedLong(hands);
  expect(hands.pressed).toHaveBeenCalledExactlyOnceWith({ latitude: 47, longitude: 8 });
  expect(hands.clicked).not.toHaveBeenCalled();
});

test('a slow click counts where a long press means nothing', () => {
  const hands = new Hands();
  hands.pressed.mockReturnValue(false);
  pressedLong(hands);
  expect(hands.clicked).toHaveBeenCalledOnce();
});

test('a press on a waypoint is never long', () => {
  const hands = new Hands(3);
  pressedLong(hands);
  expect(hands.pressed).not.toHaveBeenCalled();
  expect(hands.clicked).toHaveBeenCalledOnce();
});
