/** An operation of REST: where it is called, what it takes, what it answers. */
export interface Operation {
  readonly method: 'GET' | 'POST' | 'PUT' | 'PATCH' | 'DELETE';
  /** With the names of its parameters in braces. */
  readonly path: string;
  /** The names of parameters that stand in the query. */
  readonly query?: readonly string[];
  /** What it takes as its body; the first where nothing else is said. */
  readonly body?: readonly string[];
  readonly answer: 'json' | 'text' | 'file' | 'nothing' | 'redirect';
}

/** A file that is sent. A Blob with a type goes as what it is, where the operation takes that. */
export type FileBody = Blob | Uint8Array<ArrayBuffer> | string;

export interface CallOptions {
  /** Ends the call; it rejects with the reason of the signal. What was sent may have been done. */
  readonly signal?: AbortSignal | undefined;
  /** Milliseconds until it is given up, as if the server could not be reached. Without: as long as it takes. */
  readonly timeout?: number | undefined;
}

export type Parameters = Readonly<Record<string, string | number | boolean | null | undefined>>;

/** Path and query of an operation with these parameters; those that are null or left out are not in the query. */
export function addressOf({ path, query = [] }: Operation, parameters: Parameters = {}): string {
  const filled = path.replaceAll(/\{(\w+)\}/g, (_, name: string) =>
    encodeURIComponent(String(parameters[name] ?? '')),
  );
  const wanted = new URLSearchParams();
  for (const name of query) {
    const value = parameters[name];
    if (value !== null && value !== undefined) {
      wanted.set(name, String(value));
    }
  }
  const text = wanted.toString();
  return text === '' ? filled : `${filled}?${text}`;
}
