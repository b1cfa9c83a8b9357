/**
 * What the adapters of the store ports share.
 *
 * <p>Enters: what several adapters share.
 *
 * <p>Never: a single table.
 */
@NullMarked
package org.dronemap.store;

import org.jspecify.annotations.NullMarked;
