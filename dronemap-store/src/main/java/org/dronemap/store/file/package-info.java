/**
 * What is kept in files beside the database.
 *
 * <p>Enters: a file that must outlive the database.
 *
 * <p>Never: tables.
 */
@NullMarked
package org.dronemap.store.file;

import org.jspecify.annotations.NullMarked;
