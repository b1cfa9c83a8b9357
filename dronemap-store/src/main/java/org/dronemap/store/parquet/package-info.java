/**
 * Telemetry as files of columns, for programs that reckon.
 *
 * <p>Enters: telemetry as Parquet.
 *
 * <p>Never: queries.
 */
@NullMarked
package org.dronemap.store.parquet;

import org.jspecify.annotations.NullMarked;
