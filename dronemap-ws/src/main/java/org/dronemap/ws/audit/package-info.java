/**
 * The record of calls: searching, taking along and checking it.
 *
 * <p>Enters: what reads the record.
 *
 * <p>Never: what writes it: that is core.audit.
 */
@NullMarked
package org.dronemap.ws.audit;

import org.jspecify.annotations.NullMarked;
