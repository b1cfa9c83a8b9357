import { describe, expect, it } from 'vitest';
import type { Parameter } from '../api/parameters';
import { allowedText, searched, typedValue, valueText } from './parameter-value';

describe('a parameter', () => {
  it('shows the digits that its number carries', () => {
    expect(valueText('real32', 0.10000000149011612)).toBe('0.1');
    expect(valueText('real32', 1500)).toBe('1500');
    expect(valueText('int32', 2_147_483_647)).toBe('2147483647');
  });

  it('takes what the vehicle can hold', () => {
    expect(typedValue('int8', ' 12 ')).toBe(12);
    expect(typedValue('real32', '0,5')).toBe(0.5);
  });

  it('refuses what the vehicle cannot hold', () => {
    expect(typedValue('int8', '200')).toBeNull();
    expect(typedValue('int8', '1.5')).toBeNull();
    expect(typedValue('real32', '')).toBeNull();
    expect(typedValue('real32', 'high')).toBeNull();
    expect(allowedText('int8')).toBe('a whole number from -128 to 127');
  });

  it('is found by words of its name in any order', () => {
    const all: Parameter[] = ['RTL_ALT', 'RTL_SPEED', 'WPNAV_SPEED'].map((name) => ({
      name,
      type: 'real32',
      value: 0,
    }));
    expect(searched(all, 'speed rtl').map((one) => one.name)).toEqual(['RTL_SPEED']);
    expect(searched(all, '')).toHaveLength(3);
  });
});
