import type { Map as MapLibre } from 'maplibre-gl';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { PressGestures, type PressHandler } from './gestures';

type Listener = (event: object) => void;

/** A map that only passes on what a pointer does to it. */
class Pointer {
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

function pressedLong(pointer: Pointer): void {
  pointer.does('mousedown');
  vi.advanceTimersByTime(600);
  pointer.does('mouseup');
  pointer.does('click');
}

test('a long press that means something is not a click as well', () => {
  const pointer = new Pointer();
  pointer.pressed.mockReturnValue(true);
  pressedLong(pointer);
  expect(pointer.pressed).toHaveBeenCalledExactlyOnceWith({ latitude: 47, longitude: 8 });
  expect(pointer.clicked).not.toHaveBeenCalled();
});

test('a slow click counts where a long press means nothing', () => {
  const pointer = new Pointer();
  pointer.pressed.mockReturnValue(false);
  pressedLong(pointer);
  expect(pointer.clicked).toHaveBeenCalledOnce();
});

test('a press on a waypoint is never long', () => {
  const pointer = new Pointer(3);
  pressedLong(pointer);
  expect(pointer.pressed).not.toHaveBeenCalled();
  expect(pointer.clicked).toHaveBeenCalledOnce();
});
