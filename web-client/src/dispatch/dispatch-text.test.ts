import { describe, expect, it } from 'vitest';
import { aDispatch } from '../testing';
import { newestWords, stageText } from './dispatch-text';

describe('a drone that was sent in words', () => {
  it('says how far it is and how long it takes', () => {
    expect(stageText(aDispatch())).toBe('Falcon · on its way · 142 m · 29 s');
    expect(stageText(aDispatch({ now: null }))).toBe('Falcon · on its way');
    expect(stageText(aDispatch({ state: 'here' }))).toBe('Falcon is here: control is yours');
    expect(stageText(aDispatch({ state: 'searching', drone: null, droneName: null }))).toBe(
      'Another drone is looked for',
    );
  });

  it('says what is wrong before all else, and then why it ended', () => {
    const told = [{ at: '2026-01-01T12:00:00Z', words: 'Falcon was chosen.' }];
    expect(newestWords(aDispatch({ told }))).toBe('Falcon was chosen.');
    const here = [{ at: '2026-01-01T12:00:00Z', words: 'Falcon is here: control is yours. It holds.' }];
    expect(newestWords(aDispatch({ told: here, state: 'here' }))).toBe('It holds.');
    expect(newestWords(aDispatch({ told, end: 'No other drone can come.' }))).toBe(
      'No other drone can come.',
    );
    expect(newestWords(aDispatch({ told, note: 'There is no contact with Falcon.' }))).toBe(
      'There is no contact with Falcon.',
    );
  });
});
