import { beforeEach, describe, expect, it } from 'vitest';
import { type Dispatch, DispatchCalls, type DispatchOrder } from '../api/dispatches';
import { Problem } from '../api/problem';
import { aDispatch, operationsBy } from '../testing';
import { Dispatches } from './dispatches.svelte';

const PLACE = { latitude: 47, longitude: 8 };

let asked: DispatchOrder[];
let answer: () => Promise<Dispatch>;
let dispatches: Dispatches;

beforeEach(() => {
  asked = [];
  answer = () => Promise.resolve(aDispatch({ state: 'chosen' }));
  const calls = operationsBy((_operation, order) => {
    asked.push(order as DispatchOrder);
    return answer();
  });
  dispatches = new Dispatches(new DispatchCalls(calls));
});

describe('drones that are sent', () => {
  it('sends one to the place that was marked, and takes in hand what comes for this window, once', async () => {
    dispatches.picking = true;
    dispatches.setPlace(PLACE);
    expect(dispatches.picking).toBe(false);
    expect(await dispatches.send(30)).toBe(true);
    expect(asked).toEqual([{ ...PLACE, height: 30 }]);
    expect(dispatches.place).toBeNull();
    expect(dispatches.takeArrival()).toBeNull();
    dispatches.apply(aDispatch({ state: 'here' }));
    expect(dispatches.takeArrival()).toBe('d1');
    expect(dispatches.takeArrival()).toBeNull();
  });

  it('leaves to others what they asked for', () => {
    dispatches.apply(aDispatch({ state: 'here' }));
    expect(dispatches.takeArrival()).toBeNull();
    expect(dispatches.underWay('ann')).toHaveLength(1);
    expect(dispatches.underWay('bob')).toHaveLength(0);
  });

  it('says why none can come, and keeps the place', async () => {
    answer = () => Promise.reject(new Problem({ status: 409, detail: 'No drone can come now.' }));
    dispatches.setPlace(PLACE);
    expect(await dispatches.send(30)).toBe(false);
    expect(dispatches.problem).toBe('No drone can come now.');
    expect(dispatches.place).toEqual(PLACE);
  });

  it('shows why one has ended until that is put aside, and nothing of what was over before', () => {
    dispatches.apply(aDispatch({ state: 'over', end: 'ann called it off.' }));
    expect(dispatches.ended('ann')).toHaveLength(0);
    dispatches.apply(aDispatch());
    dispatches.apply(aDispatch({ state: 'over', end: 'ann called it off.' }));
    expect(dispatches.ended('ann')).toHaveLength(1);
    dispatches.putAside('s1');
    expect(dispatches.ended('ann')).toHaveLength(0);
  });
});
