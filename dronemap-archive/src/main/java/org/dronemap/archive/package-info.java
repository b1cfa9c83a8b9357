/**
 * Finished days of telemetry as Parquet on a Hadoop file system, each written whole, read back and only then counted.
 *
 * <p>Enters: a step of writing, checking or dropping a day.
 *
 * <p>Never: what the server itself needs to run.
 */
@NullMarked
package org.dronemap.archive;

import org.jspecify.annotations.NullMarked;
