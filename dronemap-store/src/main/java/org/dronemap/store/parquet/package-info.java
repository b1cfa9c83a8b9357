/** Telemetry as files of columns, for programs that reckon. */
@NullMarked
package org.dronemap.store.parquet;

import org.jspecify.annotations.NullMarked;
