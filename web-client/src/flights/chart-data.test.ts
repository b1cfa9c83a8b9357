import { describe, expect, it } from 'vitest';
import type { Series } from '../api/flights';
import { chartData, chartTitle } from './chart-data';

function series(seconds: number[], least: (number | null)[], most: (number | null)[]): Series {
  return {
    drone: 'd1',
    from: new Date(0).toISOString(),
    until: new Date(100_000).toISOString(),
    slotSeconds: 2,
    times: seconds.map((second) => new Date(second * 1000).toISOString()),
    fields: [{ name: 'groundSpeed', unit: 'm/s', least, most }],
  };
}

describe('the data of a chart', () => {
  it('draws the least and the greatest value of each slot', () => {
    const data = chartData(series([0, 2], [1, 5], [9, 5]), 'groundSpeed');

    expect(data.values).toEqual([1, 9, 5]);
    expect(data.times).toEqual([0, 1, 2]);
  });

  it('draws a steady descent as one', () => {
    const data = chartData(series([0, 2, 4], [9, 6, 3], [9, 8, 5]), 'groundSpeed');

    expect(data.values).toEqual([9, 8, 6, 5, 3]);
  });

  it('draws shares in percent', () => {
    const { fields, ...rest } = series([0], [0.25], [0.5]);
    const lost = fields.map((field) => ({ ...field, name: 'lossShort' }));

    expect(chartData({ ...rest, fields: lost }, 'lossShort').values).toEqual([25, 50]);
  });

  it('leaves a gap where nothing was measured', () => {
    const data = chartData(series([0, 60], [1, 2], [1, 2]), 'groundSpeed');

    expect(data.values).toEqual([1, null, 2]);
  });

  it('never goes back in time', () => {
    const data = chartData(series([0, 1, 2], [1, 1, 1], [2, 2, 2]), 'groundSpeed');

    expect(data.times).toEqual([...data.times].sort((one, other) => one - other));
    expect(new Set(data.times).size).toBe(data.times.length);
  });

  it('has nothing of a field that is not there', () => {
    expect(chartData(series([0], [1], [1]), 'wings').values).toEqual([null]);
  });

  it('says what is drawn, with the unit', () => {
    expect(chartTitle('groundSpeed', 'm/s')).toBe('Ground speed, m/s');
    expect(chartTitle('satellites', '')).toBe('Satellites');
    expect(chartTitle('lossShort', '')).toBe('Messages lost (5 s), %');
  });
});
