export type ParameterType =
  'int8' | 'uint8' | 'int16' | 'uint16' | 'int32' | 'uint32' | 'int64' | 'uint64' | 'real32' | 'real64';

/** A setting of the vehicle itself, as last heard from it. */
export interface Parameter {
  name: string;
  type: ParameterType;
  value: number;
}

export interface ParameterPage {
  /** Null until all of them were first read from the vehicle. */
  readAt: string | null;
  total: number;
  parameters: Parameter[];
}

/** A value in a file that is not the vehicle's. */
export interface ParameterDifference {
  name: string;
  type: ParameterType;
  held: number;
  wanted: number;
}

/** How a file compares with what the vehicle holds; what it does not have or cannot hold is left out. */
export interface ParameterFile {
  different: ParameterDifference[];
  same: number;
  unknown: string[];
  unfit: ParameterDifference[];
}
