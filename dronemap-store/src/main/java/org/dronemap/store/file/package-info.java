/** What is kept in files beside the database. */
@NullMarked
package org.dronemap.store.file;

import org.jspecify.annotations.NullMarked;
