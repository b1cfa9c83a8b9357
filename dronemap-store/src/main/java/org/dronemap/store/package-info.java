/** What the adapters of the store ports share. */
@NullMarked
package org.dronemap.store;

import org.jspecify.annotations.NullMarked;
