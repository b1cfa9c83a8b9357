package org.dronemap.ws.user;

import org.springframework.context.annotation.Configuration;
import org.springframework.context.annotation.Import;

/** Spring configuration of the handlers and services for users, their sign-in and invitations. */
@Configuration(proxyBeanMethods = false)
@Import({
    SessionController.class,
    UserController.class,
    OidcController.class,
    RegistrationController.class,
    InvitationController.class,
    StreamTicketController.class,
    AccountService.class,
    UserService.class,
    RegistrationService.class,
    InvitationService.class
})
class UserConfiguration {}
