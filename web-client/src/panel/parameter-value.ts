import type { Parameter, ParameterType } from '../api/parameters';

const RANGES: Partial<Record<ParameterType, [number, number]>> = {
  int8: [-128, 127],
  uint8: [0, 255],
  int16: [-32_768, 32_767],
  uint16: [0, 65_535],
  int32: [-2_147_483_648, 2_147_483_647],
  uint32: [0, 4_294_967_295],
  int64: [Number.MIN_SAFE_INTEGER, Number.MAX_SAFE_INTEGER],
  uint64: [0, Number.MAX_SAFE_INTEGER],
};

/** 0.1, not 0.10000000149: as many digits as the vehicle's number carries. */
export function valueText(type: ParameterType, value: number): string {
  return String(type === 'real32' ? Number(value.toPrecision(7)) : value);
}

/** The allowed values, as text. */
export function allowedText(type: ParameterType): string {
  const range = RANGES[type];
  return range === undefined ? 'a number' : `a whole number from ${range[0]} to ${range[1]}`;
}

/** The number that was typed, or null when the vehicle cannot hold it. */
export function typedValue(type: ParameterType, text: string): number | null {
  const value = text.trim() === '' ? Number.NaN : Number(text.trim().replace(',', '.'));
  const range = RANGES[type];
  const fits =
    range === undefined
      ? Number.isFinite(value)
      : Number.isInteger(value) && value >= range[0] && value <= range[1];
  return fits ? value : null;
}

/** Those whose name has all the words in it, in any order. */
export function searched(parameters: readonly Parameter[], words: string): readonly Parameter[] {
  const wanted = words.toUpperCase().split(/\s+/).filter(Boolean);
  return parameters.filter(({ name }) => wanted.every((word) => name.toUpperCase().includes(word)));
}
