import type { ParameterView as Parameter } from '@dronemap/client';

export type { Parameter };
export type {
  ParametersDifferenceView as ParameterDifference,
  ParametersFileView as ParameterFile,
  ParametersView as ParameterPage,
} from '@dronemap/client';

export type ParameterType = Parameter['type'];
