/** Tests of what runs and counts; short searches only. */
@NullMarked
package org.dronemap.bench.planning;

import org.jspecify.annotations.NullMarked;
