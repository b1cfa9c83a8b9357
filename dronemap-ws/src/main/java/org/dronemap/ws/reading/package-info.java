/**
 * Reading of requests: JSON, names, ranges, moments, and the words that enumerations have on the wire.
 *
 * <p>Enters: what several features read alike.
 *
 * <p>Never: what one feature alone reads.
 */
@NullMarked
package org.dronemap.ws.reading;

import org.jspecify.annotations.NullMarked;
