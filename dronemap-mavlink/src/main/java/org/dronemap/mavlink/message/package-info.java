/** The messages that this product reads or writes, as records of their raw fields; generated. */
@NullMarked
package org.dronemap.mavlink.message;

import org.jspecify.annotations.NullMarked;
