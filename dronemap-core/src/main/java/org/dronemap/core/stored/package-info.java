/**
 * Names under which what is stored stays readable, whatever the code calls it.
 *
 * <p>Enters: how a stored name is declared.
 *
 * <p>Never: what is stored.
 */
@NullMarked
package org.dronemap.core.stored;

import org.jspecify.annotations.NullMarked;
