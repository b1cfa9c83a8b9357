import { describe, expect, it } from 'vitest';
import type { LinkState } from '../api/types';
import { droneFeatures } from '../map/features';
import { aDrone } from '../testing';
import { linkMark, linkStateText, outdatedText, statusOf } from './drone-status';

const replayed = (state: LinkState) =>
  aDrone({ replay: true, armed: true, link: { ...aDrone().link, state } });

describe('status', () => {
  it('names what a drone has stopped telling though it is heard', () => {
    const lastHeard = '2026-01-01T00:00:00Z';
    const drone = aDrone({
      link: {
        ...aDrone().link,
        outdated: [
          { part: 'position', lastHeard },
          { part: 'battery', lastHeard },
        ],
      },
    });
    expect(outdatedText(drone, () => 20_000)).toMatch(
      /^Old values: position \(20 s ago\), battery \(20 s ago\)$/u,
    );
    expect(outdatedText(aDrone(), () => 0)).toBeNull();
  });

  it('calls a replay that has ended just that, and no lost drone', () => {
    expect(statusOf(replayed('ended'))).toEqual({ word: 'Replay ended', tone: 'neutral' });
    expect(linkStateText('ended')).toBe('Ended');
  });

  it('marks a link that is heard and gets worse', () => {
    const link = (state: LinkState, trend: 'steady' | 'worse' | 'falling') => ({
      ...aDrone().link,
      state,
      trend: { state: trend, secondsLeft: null, sentence: '' },
    });
    expect(linkMark(link('live', 'falling'))).toEqual({ words: 'Link falling', tone: 'red' });
    expect(linkMark(link('live', 'worse'))).toEqual({ words: 'Link worse', tone: 'amber' });
    expect(linkMark(link('live', 'steady'))).toEqual({ words: 'Live', tone: 'neutral' });
    expect(linkMark(link('lost', 'falling')).words).toBe(linkStateText('lost'));
    expect(linkMark(link('live', 'falling'), true).words).toBe('Offline');
  });

  it('does not count on the map how long ago a replay ended', () => {
    const [ended] = droneFeatures([replayed('ended')], null, () => 90_000).features;
    expect(ended?.properties).toMatchObject({ age: '', icon: expect.stringContaining('plain') as string });
    const [lost] = droneFeatures([replayed('lost')], null, () => 90_000).features;
    expect(lost?.properties?.['age']).toBe('1 min ago');
  });

  it('alarms of a lost drone only when it may still fly', () => {
    const lost = aDrone({ link: { ...aDrone().link, state: 'lost' }, armed: true });
    expect(statusOf(lost).tone).toBe('red');
    expect(statusOf({ ...lost, armed: false }).tone).toBe('neutral');
  });
});
