/** What a field of a search asks for; null: anything. */
export function wordsOf(field: string): string | null {
  return field.trim() === '' ? null : field.trim();
}

/** The moment that a field with a local time names; null: none. */
export function timeOf(field: string): string | null {
  const time = new Date(field);
  return Number.isNaN(time.getTime()) ? null : time.toISOString();
}
