/** Finished days of telemetry as Parquet on a Hadoop file system, each written whole, read back and only then counted. */
@NullMarked
package org.dronemap.archive;

import org.jspecify.annotations.NullMarked;
