import type { ParameterView as Parameter } from './contract';

export type { Parameter };
export type {
  ParametersDifferenceView as ParameterDifference,
  ParametersFileView as ParameterFile,
  ParametersView as ParameterPage,
} from './contract';

export type ParameterType = Parameter['type'];
