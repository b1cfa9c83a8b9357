/**
 * Accounts as sign-in needs them: passwords and their rules, names, users of other providers.
 *
 * <p>Enters: what proves or names an account.
 *
 * <p>Never: handlers: those are in user.
 */
@NullMarked
package org.dronemap.ws.account;

import org.jspecify.annotations.NullMarked;
