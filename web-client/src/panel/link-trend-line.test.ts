import { render, screen } from '@testing-library/svelte';
import { describe, expect, it } from 'vitest';
import type { LinkSample } from '../state/link-history';
import { aDrone } from '../testing';
import Instruments from './Instruments.svelte';
import { lineParts, lineWords } from './link-trend-line';

function samples(...received: number[]): LinkSample[] {
  return received.map((share, index) => ({ at: index * 60_000, received: share, begins: index === 0 }));
}

describe('the line of a link', () => {
  it('has its figures in words', () => {
    expect(lineWords(samples(1, 0.91, 0.975))).toBe('98 % received, 91 % at worst in 2 min');
    expect(lineWords(samples(1, 1))).toBe('100 % received, 100 % at worst in 1 min');
    expect(lineWords(samples(1, 0.999))).toBe('99 % received, 99 % at worst in 1 min');
    expect(lineWords(samples(1))).toBeNull();
    expect(lineWords([])).toBeNull();
  });

  it('is five minutes wide, and draws small losses large', () => {
    expect(lineParts(samples(1, 0.9))).toEqual(['76.8,1.0 96.0,12.0']);
    expect(lineParts(samples(1, 0))).toEqual(['76.8,1.0 96.0,23.0']);
  });

  it('is broken where nothing is known', () => {
    const [first, second, third, fourth] = samples(1, 1, 1, 1);
    const parts = lineParts([first, second, { ...third, begins: true }, fourth] as LinkSample[]);
    expect(parts).toHaveLength(2);
  });

  it('stands beside the readings of the drone', () => {
    const { container } = render(Instruments, { drone: aDrone(), links: samples(1, 0.9) });
    expect(screen.getByText('90 % received, 90 % at worst in 1 min')).toBeTruthy();
    expect(container.querySelectorAll('polyline')).toHaveLength(1);
  });
});
