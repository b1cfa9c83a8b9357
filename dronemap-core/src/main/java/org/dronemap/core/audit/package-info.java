/**
 * What was done by whom: records in a chain that shows every later change of them.
 *
 * <p>Enters: what a record says, and how records are chained.
 *
 * <p>Never: what is recorded: each face says that.
 */
@NullMarked
package org.dronemap.core.audit;

import org.jspecify.annotations.NullMarked;
