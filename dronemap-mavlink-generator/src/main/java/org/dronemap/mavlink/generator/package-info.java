/**
 * Makes the records of MAVLink messages from their definitions; runs within the build, and never with the product.
 *
 * <p>Enters: what the records need.
 *
 * <p>Never: anything at run time.
 */
@NullMarked
package org.dronemap.mavlink.generator;

import org.jspecify.annotations.NullMarked;
