import { expect, it } from 'vitest';
import { age, counted, distance, fixed, heading, span } from './format';

it('shows an unknown fact as a dash, never as zero', () => {
  expect(fixed(null, 1)).toBe('—');
  expect(heading(undefined)).toBe('—');
  expect(age(null)).toBe('—');
  expect(fixed(0, 1)).toBe('0.0');
});

it('does not flicker between zero and minus zero', () => {
  expect(fixed(-0.04, 1)).toBe('0.0');
  expect(fixed(-1.25, 1)).toBe('−1.3');
});

it('writes headings as three figures', () => {
  expect(heading(7.6)).toBe('008');
  expect(heading(359.7)).toBe('000');
  expect(heading(-90)).toBe('270');
});

it('says how long ago in few words', () => {
  expect(age(1500)).toBe('now');
  expect(age(12_400)).toBe('12 s ago');
  expect(age(180_000)).toBe('3 min ago');
  expect(span(75)).toBe('1 min 15 s');
});

it('changes from metres to kilometres', () => {
  expect(distance(999)).toBe('999 m');
  expect(distance(1530)).toBe('1.53 km');
});

it('says one of them in the singular', () => {
  expect(counted(1, 'item')).toBe('1 item');
  expect(counted(0, 'item')).toBe('0 items');
});
