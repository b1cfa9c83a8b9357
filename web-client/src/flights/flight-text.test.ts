import { expect, test } from 'vitest';
import type { FlightEvent } from '../api/flights';
import { eventText } from './flight-text';

const COMMAND: FlightEvent = {
  at: '2026-03-04T05:06:07Z',
  kind: 'command',
  text: 'arm',
  severity: null,
  by: 'ann',
  command: 'c-1',
  result: 'refused',
  reason: 'No GPS fix.',
};

test('shows who commanded and what became of it', () => {
  expect(eventText(COMMAND)).toBe('arm by ann: refused, No GPS fix.');
});

test('names somebody once whom the sentence names itself', () => {
  const control: FlightEvent = {
    ...COMMAND,
    kind: 'control',
    text: 'ann took control.',
    result: null,
    reason: null,
  };
  expect(eventText(control)).toBe('ann took control.');
});
