/** Tests of the archive. */
@NullMarked
package org.dronemap.archive;

import org.jspecify.annotations.NullMarked;
