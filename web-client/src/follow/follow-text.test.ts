import { describe, expect, it } from 'vitest';
import type { FollowStage } from '../api/follows';
import { aDrone, aFollow } from '../testing';
import { demoFix, TRACK } from './demo-walk';
import { distanceMeters } from '../geo/distance';
import { availableDrones, demoBegin, mine, placeChange } from './following';
import {
  isIdle,
  dependsOnPhone,
  followText,
  absenceText,
  offered,
  otherDroneTexts,
  placeText,
  overviewNote,
  stageText,
  ACTIONS,
  actionText,
} from './follow-text';
import { outageState } from './outage';
import { ALARM, Vibration } from './vibration';

const STAGES: FollowStage[] = [
  'allocated',
  'starting',
  'tracking',
  'paused',
  'suspended',
  'returning',
  'over',
];

describe('the stages of a follow', () => {
  it('have words of their own each, and name the drone', () => {
    const all = STAGES.map((state) => stageText(aFollow({ state })));
    expect(new Set(all.map(({ title }) => title)).size).toBe(STAGES.length);
    all.forEach(({ words }) => expect(words).toContain('Copter 1'));
  });

  it('do not say that it follows while it does not', () => {
    const note = 'The phone says nothing any more. Copter 1 waits.';
    const waits = aFollow({ state: 'tracking', note });
    expect(stageText(waits)).toEqual({ title: 'Not following now', tone: 'amber', words: note });
    expect(followText(waits)).toBe('Copter 1 is not following olga');
    const unled = stageText(aFollow({ state: 'tracking' }), true);
    expect(unled).toEqual({ title: 'Not following now', tone: 'amber', words: 'Copter 1 is not led now.' });
    expect(stageText(aFollow({ state: 'paused' }), true).title).toBe('Paused');
  });

  it('offer what the cloud would take, and nothing else', () => {
    expect(STAGES.map((state) => [state, ...offered(aFollow({ state }))])).toEqual([
      ['allocated', 'start', 'cancel'],
      ['starting', 'cancel'],
      ['tracking', 'pause', 'stop'],
      ['paused', 'continue', 'stop'],
      ['suspended', 'continue', 'stop'],
      ['returning'],
      ['over'],
    ]);
  });

  it('want holding for whatever sets the drone in motion or cannot be undone', () => {
    expect(Object.entries(ACTIONS).filter(([, { hold }]) => hold)).toHaveLength(3);
    expect(ACTIONS.pause.hold).toBe(false);
    expect(ACTIONS.stop.effect).toContain('not beside you');
    expect(ACTIONS.pause.effect).toContain('in the air');
  });

  it('do not say who has a drone that was taken: the follow does', () => {
    const taken = aFollow({ state: 'suspended', note: 'Nobody has Copter 1 any more.' });
    expect(stageText(taken).title).toBe('Control lost');
    expect(stageText(taken).words).toContain('“Resume” takes control of it again.');
    expect(followText(taken)).toBe('Copter 1 is under other control and does not follow olga');
    expect(outageState(taken, 10).words).toBe('Nobody has Copter 1 any more.');
    // The cloud leaves it to whoever has it.
    expect(actionText('stop', 'suspended').effect).toContain('keeps it; one that nobody has');
    expect(actionText('stop', 'tracking')).toBe(ACTIONS.stop);
  });

  it('hang on the phone while it leads the drone', () => {
    expect(STAGES.filter((state) => dependsOnPhone(aFollow({ state })))).toEqual(['starting', 'tracking']);
    expect(dependsOnPhone(null)).toBe(false);
    expect(STAGES.filter((state) => isIdle(aFollow({ state })))).toEqual(['returning', 'over']);
    expect(isIdle(null)).toBe(false);
  });

  it('show the station who is followed by which drone', () => {
    expect(followText(aFollow({ state: 'tracking' }))).toBe('Copter 1 follows olga');
    expect(new Set(STAGES.map((state) => followText(aFollow({ state })))).size).toBe(STAGES.length);
    expect(followText(aFollow({ state: 'tracking' }), true)).toBe('Copter 1 stands still and waits for olga');
  });
});

describe('the closed list of the station', () => {
  it('says first what is wrong, in few words', () => {
    const well = aFollow({ state: 'tracking' });
    const kept = aFollow({ id: 'f2', state: 'tracking', note: 'A zone is in its way.' });
    expect(overviewNote([], () => false)).toBe('');
    expect(overviewNote([well, well], () => false)).toBe('2 under way');
    expect(overviewNote([well, kept], () => false)).toBe('1 held up of 2');
    expect(overviewNote([well, kept], (follow) => follow === well)).toBe('1 silent of 2');
  });
});

describe('a drone that comes to replace another one', () => {
  const kestrel = { drone: 'd2', droneName: 'Kestrel', state: 'starting', comes: true } as const;

  it('is named, to whoever is followed and on the station', () => {
    const follow = aFollow({ state: 'tracking', others: [kestrel] });
    expect(otherDroneTexts(follow)).toEqual(['Kestrel comes to replace Copter 1.']);
    expect(followText(follow)).toBe('Copter 1 follows olga; Kestrel comes to replace it');
  });

  it('can be called off when the other one flies home already', () => {
    const follow = aFollow({ state: 'returning', others: [kestrel] });
    expect(offered(follow)).toEqual(['stop']);
    expect(isIdle(follow)).toBe(false);
    expect(offered({ ...follow, others: [{ ...kestrel, state: 'returning', comes: false }] })).toEqual([]);
  });

  it('has the one that it replaced told of until that is down', () => {
    const falcon = { ...kestrel, droneName: 'Falcon', comes: false };
    expect(otherDroneTexts(aFollow({ others: [{ ...falcon, state: 'returning' }] }))).toEqual([
      'Falcon flies home.',
    ]);
    expect(otherDroneTexts(aFollow({ others: [{ ...falcon, state: 'suspended' }] }))).toEqual([
      'Somebody else flies Falcon.',
    ]);
  });
});

describe('what the drone did while the phone was away', () => {
  const at = (second: number): string => new Date(Date.UTC(2026, 0, 1, 12, 0, second)).toISOString();
  const absence = { why: 'unanswered', seconds: 34, waited: 32, from: Date.parse(at(10)), until: 0 } as const;
  const first = { at: at(5), words: 'Copter 1 is in the air and follows.' };
  const follow = aFollow({ state: 'tracking', since: at(5), told: [first] });

  it('is not claimed where the cloud says nothing of it', () => {
    expect(absenceText(follow, absence)).toBe('');
  });

  it('is that it stood, where the cloud led it all the time', () => {
    const told = [first, { at: at(13), words: 'Copter 1 waits.' }];
    expect(absenceText({ ...follow, told }, absence)).toBe(
      'The drone stood and waited for 32 s. Now it follows you again.',
    );
    expect(absenceText({ ...follow, told, note: 'There is no contact.' }, absence)).not.toContain('Now');
  });

  it('is in the words of the cloud, where it came home meanwhile', () => {
    const told = [first, { at: at(43), words: 'Copter 1 came home since it had missed the cloud.' }];
    expect(absenceText({ ...follow, since: at(43), told }, absence)).toBe(
      'Copter 1 came home since it had missed the cloud.',
    );
  });
});

describe('where the drone stays', () => {
  const { place } = aFollow();

  it('is said in words', () => {
    expect(placeText(place)).toBe('8 m behind you, 15 m up');
    expect(placeText({ ...place, side: 'fixed', bearing: 315 })).toContain('north-west of you');
    expect(placeText({ ...place, side: 'fixed', bearing: -90 })).toContain('west of you');
  });

  it('goes to the cloud with what its side needs', () => {
    expect(placeChange({ ...place, bearing: 90, turn: 5 })).toEqual({
      side: 'behind',
      distance: 8,
      height: 15,
    });
    expect(placeChange({ ...place, side: 'fixed' })).toMatchObject({ bearing: 0 });
    expect(placeChange({ ...place, side: 'orbit' })).toMatchObject({ turn: 10 });
  });
});

describe('who is asked', () => {
  const drone = aDrone();

  it('are drones that can be heard and know their home', () => {
    const lost = aDrone({ id: 'd2', link: { ...drone.link, state: 'lost' } });
    expect(availableDrones([drone, lost, aDrone({ home: null }), aDrone({ replay: true })])).toEqual([drone]);
  });

  it('is not the follow of somebody else, nor one that is over', () => {
    const over = aFollow({ state: 'over' });
    expect(mine([over, aFollow({ owner: 'ann' }), aFollow({ id: 'f2' })], 'olga')?.id).toBe('f2');
    expect(mine([over], 'olga')).toBeNull();
  });

  it('lets the demo walk begin beside the wanted drone’s home', () => {
    const begin = demoBegin([drone], 'd1');
    expect(begin && distanceMeters(begin, drone.home ?? begin)).toBeCloseTo(20, 0);
    expect(demoBegin([], null)).toBeNull();
  });
});

describe('the demo walk', () => {
  const begin = { latitude: 47, longitude: 8 };

  it('goes round without a leap, at what people can run', () => {
    const steps = Array.from({ length: 2 * TRACK.length }, (_, second) => demoFix(begin, second, second));
    const speeds = steps.slice(1).map((fix, index) => distanceMeters(fix, steps[index] ?? fix));
    expect(Math.max(...speeds)).toBeLessThan(4.5);
    expect(speeds.filter((speed) => speed > 2.5).length).toBeGreaterThan(20);
    expect(Math.max(...steps.map((fix) => distanceMeters(fix, begin)))).toBeLessThan(80);
  });
});

describe('what the hand feels', () => {
  it('is each new stage once, and each new alarm', () => {
    const felt: number[][] = [];
    const vibration = new Vibration((pattern) => felt.push(pattern));
    const starting = aFollow({ state: 'starting' });
    const tracking = aFollow({ state: 'tracking' });
    vibration.update(null, []);
    vibration.update(starting, []);
    vibration.update(starting, []);
    vibration.update(tracking, []);
    expect(felt).toHaveLength(2);
    vibration.update(tracking, ['cut-off']);
    vibration.update(tracking, ['cut-off']);
    expect(felt.slice(2)).toEqual([[...ALARM]]);
    vibration.update(tracking, []);
    vibration.update(tracking, ['cut-off']);
    expect(felt).toHaveLength(4);
  });

  it('is another drone that has taken over', () => {
    const felt: number[][] = [];
    const vibration = new Vibration((pattern) => felt.push(pattern));
    vibration.update(aFollow({ state: 'tracking' }), []);
    vibration.update(aFollow({ state: 'tracking', drone: 'd2' }), []);
    expect(felt).toHaveLength(2);
  });
});
