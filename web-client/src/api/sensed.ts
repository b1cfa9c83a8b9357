/** The numbers of the newest that its sensors brought; null where there was none. */
export interface SensedNumbers {
  scan: number | null;
  picture: number | null;
  map: number | null;
}

/** The newest that a drone's sensors brought. */
export interface Sensed {
  /** Metres along rays counter-clockwise from the nose, null where nothing was met; degrees. */
  scan: { number: number; firstAngle: number; angleStep: number; ranges: (number | null)[] } | null;
  picture: { number: number; at: string; mediaType: string } | null;
  /** Its edges in metres of the vehicle's own frame. */
  map: { number: number; left: number; bottom: number; width: number; height: number } | null;
}
