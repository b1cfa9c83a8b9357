/** The requirements of a waypoint beside its place; null: none. */
export interface Requirements {
  priority: number | null;
  /** Seconds after the start of the plan. */
  opens: number | null;
  closes: number | null;
  picture: boolean;
  photo: boolean;
  servo: number | null;
  /** Microseconds. */
  pulse: number | null;
  /** For how many seconds sensors are read. */
  sensors: number | null;
}

export const NO_REQUIREMENTS: Requirements = {
  priority: null,
  opens: null,
  closes: null,
  picture: false,
  photo: false,
  servo: null,
  pulse: null,
  sensors: null,
};

/** The weight of a waypoint when not all can be visited. */
export const PRIORITIES: [number | null, string][] = [
  [0.1, 'low'],
  [null, 'usual'],
  [10, 'high'],
  [1000, 'before all others'],
];
