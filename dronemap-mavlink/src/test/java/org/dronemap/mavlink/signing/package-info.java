/** Tests of signatures, against bytes that another implementation made. */
@NullMarked
package org.dronemap.mavlink.signing;

import org.jspecify.annotations.NullMarked;
