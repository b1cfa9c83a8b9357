import { describe, expect, it } from 'vitest';
import css from './tokens.css?raw';

const themes = { light: tokensOf(':root {'), dark: tokensOf(":root[data-theme='dark'] {") };

/** Text and what it stands on. */
const PAIRS: [string, string][] = [
  ...['surface', 'surface-sunken', 'surface-raised', 'surface-hover'].flatMap((ground): [string, string][] =>
    ['text', 'text-muted', 'blue', 'green', 'amber', 'red', 'violet'].map((ink) => [ink, ground]),
  ),
  ['text', 'blue-soft'],
  ['text-muted', 'blue-soft'],
  ['blue', 'blue-soft'],
  ['green', 'blue-soft'],
  ['amber', 'blue-soft'],
  ['red', 'blue-soft'],
  ['green', 'green-soft'],
  ['amber', 'amber-soft'],
  ['red', 'red-soft'],
  ['violet', 'violet-soft'],
  ['on-blue', 'blue'],
  ['on-violet', 'violet'],
  ['on-red', 'red'],
  ['map-text', 'map-land'],
  ['map-text', 'map-water'],
  ['text', 'map-land'],
  ...[0, 1, 2, 3, 4, 5].map((tone): [string, string] => [`tour-${tone}`, 'map-land']),
];

describe.each(Object.entries(themes))('%s theme', (_, tokens) => {
  it.each(PAIRS)('%s on %s can be read (4.5:1)', (ink, ground) => {
    expect(contrast(tokens.get(ink) ?? '', tokens.get(ground) ?? '')).toBeGreaterThanOrEqual(4.5);
  });

  it('shows the edge of a field (3:1)', () => {
    const edge = contrast(tokens.get('line-strong') ?? '', tokens.get('surface') ?? '');
    expect(edge).toBeGreaterThanOrEqual(3);
  });
});

function tokensOf(selector: string): Map<string, string> {
  const start = css.indexOf(selector);
  const block = css.slice(start, css.indexOf('}', start));
  return new Map(
    [...block.matchAll(/--([\w-]+):\s*(#[0-9a-f]{6})/g)].map(([, name, value]) => [name ?? '', value ?? '']),
  );
}

function contrast(one: string, other: string): number {
  const [light = 0, dark = 0] = [luminance(one), luminance(other)].sort((a, b) => b - a);
  return (light + 0.05) / (dark + 0.05);
}

/** Relative luminance of WCAG 2. */
function luminance(hex: string): number {
  const [red = 0, green = 0, blue = 0] = [1, 3, 5].map((at) => {
    const part = Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}
