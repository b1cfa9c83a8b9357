package org.dronemap.ws.user;

import io.swagger.v3.oas.annotations.Operation;
import io.swagger.v3.oas.annotations.media.Schema;
import io.swagger.v3.oas.annotations.tags.Tag;
import java.util.List;
import org.dronemap.ws.access.Access;
import org.dronemap.ws.access.AccessLevel;
import org.dronemap.ws.access.ResourceScope;
import org.dronemap.ws.http.ResponseStatuses;
import org.dronemap.ws.key.AccessKeyService;
import org.dronemap.ws.security.CurrentPrincipal;
import org.springframework.http.HttpStatus;
import org.springframework.http.ResponseEntity;
import org.springframework.web.bind.annotation.DeleteMapping;
import org.springframework.web.bind.annotation.GetMapping;
import org.springframework.web.bind.annotation.PatchMapping;
import org.springframework.web.bind.annotation.PathVariable;
import org.springframework.web.bind.annotation.PostMapping;
import org.springframework.web.bind.annotation.RequestBody;
import org.springframework.web.bind.annotation.RequestMapping;
import org.springframework.web.bind.annotation.ResponseStatus;
import org.springframework.web.bind.annotation.RestController;

/** REST handlers by which administrators manage users and their access keys. */
@RestController
@RequestMapping("/api/v1/users")
@Tag(
        name = "Users",
        description = "Who may come in, and as what; for administrators. A change takes effect at once,"
                + " on open streams as well.")
class UserController {
    private final UserService users;
    private final AccessKeyService keys;
    private final CurrentPrincipal current;

    /** All users. */
    @Schema(name = "Users")
    public record Users(List<UserView> users) {}

    UserController(UserService users, AccessKeyService keys, CurrentPrincipal current) {
        this.users = users;
        this.keys = keys;
        this.current = current;
    }

    @GetMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @Operation(
            operationId = "listUsers",
            summary = "List the users",
            description = "With those who wait until they are let in.")
    public Users users() {
        return new Users(users.users(current.principal()));
    }

    @PostMapping
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(201)
    @Operation(
            operationId = "addUser",
            summary = "Add a user",
            description = "The password serves for the first sign-in; the user then has to take another one.")
    public ResponseEntity<UserView> add(@RequestBody UserService.NewUser request) {
        return ResponseEntity.status(HttpStatus.CREATED).body(users.add(current.principal(), request));
    }

    @PatchMapping("/{name}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @Operation(
            operationId = "changeUser",
            summary = "Change a user's role, let a waiting one in, disable one",
            description = "Disabling ends sessions and streams and makes access keys void until the user is active"
                    + " again.")
    public UserView change(@PathVariable String name, @RequestBody UserService.Change change) {
        return users.change(current.principal(), name, change);
    }

    @PostMapping("/{name}/password")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @Operation(
            operationId = "resetPassword",
            summary = "Give a user a one-time password",
            description = "It is in this answer and never shown again; it serves until the user has taken another one.")
    public UserService.OneTimePassword resetPassword(@PathVariable String name) {
        return users.resetPassword(current.principal(), name);
    }

    @PostMapping("/{name}/sign-out")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(never = 409)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(
            operationId = "signOutUser",
            summary = "End all sessions of a user",
            description = "Access keys stay; see those.")
    public void signOut(@PathVariable String name) {
        users.signOut(current.principal(), name);
    }

    @GetMapping("/{name}/access-keys")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @Operation(
            operationId = "listUserAccessKeys",
            summary = "List a user's access keys",
            description = "What they may do and when they were last used.")
    public AccessKeyService.Keys accessKeys(@PathVariable String name) {
        return new AccessKeyService.Keys(keys.keysOf(current.principal(), name));
    }

    @DeleteMapping("/{name}/access-keys/{id}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "deleteUserAccessKey", summary = "Remove an access key of a user, with those made from it")
    public void deleteAccessKey(@PathVariable String name, @PathVariable String id) {
        keys.deleteKeyOf(current.principal(), name, id);
    }

    @DeleteMapping("/{name}")
    @Access(from = AccessLevel.ADMINISTRATOR, about = ResourceScope.ORGANISATION)
    @ResponseStatuses(refuses = 409)
    @ResponseStatus(HttpStatus.NO_CONTENT)
    @Operation(operationId = "deleteUser", summary = "Remove a user with sessions and keys")
    public void delete(@PathVariable String name) {
        users.delete(current.principal(), name);
    }
}
